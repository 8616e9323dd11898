/* A right answer in plain C, with which wrong.diff begins. */

double next_meeting(size_t n, double length, const double x[],
                    const double v[], size_t *left)
{
    double best = INFINITY;
    size_t i;

    for (i = 0; i < n; i++) {
        size_t j = (i + 1) % n;
        double u = v[i] - v[j];
        double d = j == 0 ? x[0] + length - x[i] : x[j] - x[i];
        if (d < 0)
            d = 0;
        if (u > 0 && d / u < best) {
            best = d / u;
            *left = i;
        }
    }
    return best;
}
