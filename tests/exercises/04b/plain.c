/* A right answer in plain C, with which wrong.diff begins. */

double rain_force(size_t n, const struct sort rain[], double im, double V,
                  double *friction)
{
    double f = 0, g = 0;
    size_t i;
    for (i = 0; i < n; i++) {
        double v = rain[i].v, l = rain[i].left, r = rain[i].right;
        double p = 2 / (1 / rain[i].m + im);
        double many = v > 0 ? l : r, s = v > 0 ? 1 : -1;
        f += s * p * many * v * (v - 2 * V);
        g += 2 * p * many * fabs(v);
    }
    *friction = g;
    return f;
}
