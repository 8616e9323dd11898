/* A right answer: the two sides one after the other, with masses. */

double rain_force(size_t n, const struct sort rain[], double im, double V,
                  double *friction)
{
    double f = 0, g = 0;
    size_t i;
    for (i = 0; i < n; i++) {
        double m = rain[i].m, v = rain[i].v;
        double p = 2 * m;
        if (im > 0)
            p = 2 * m / (1 + m * im);
        if (v > 0) {
            f += p * rain[i].left * v * (v - 2 * V);
            g += 2 * p * rain[i].left * v;
        }
        if (v < 0) {
            f -= p * rain[i].right * v * (v - 2 * V);
            g -= 2 * p * rain[i].right * v;
        }
    }
    *friction = g;
    return f;
}
