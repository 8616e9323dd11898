/* A right answer: the largest inverse time, bead by bead; the seam last. */

static double closing(double a, double b, double va, double vb)
{
    if (va <= vb)
        return 0;
    return b > a ? (va - vb) / (b - a) : INFINITY;
}

double next_meeting(size_t n, double length, const double x[],
                    const double v[], size_t *left)
{
    double rate, most = 0;
    size_t i;
    for (i = 1; i < n; i++) {
        rate = closing(x[i - 1], x[i], v[i - 1], v[i]);
        if (rate > most) {
            most = rate;
            *left = i - 1;
        }
    }
    rate = closing(x[n - 1], x[0] + length, v[n - 1], v[0]);
    if (rate > most) {
        most = rate;
        *left = n - 1;
    }
    return 1 / most;
}
