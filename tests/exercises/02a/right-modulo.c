/* A right answer: the right neighbour by the remainder. */

double next_meeting(size_t n, double length, const double x[],
                    const double v[], size_t *left)
{
    double best = INFINITY;
    size_t i;
    *left = n;
    for (i = 0; i < n; i++) {
        size_t j = (i + 1) % n;
        double u = v[i] - v[j];
        double d = x[j] - x[i] + (j == 0 ? length : 0);
        if (d < 0)
            d = 0;
        if (u > 0 && d / u < best) {
            best = d / u;
            *left = i;
        }
    }
    return best;
}
