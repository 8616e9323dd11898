/* A right answer: the exact force is a parabola in V, and its slope is what
   a wall at 1 m/s and one at -1 m/s have as their half difference; the
   particles that they would overtake are no matter for a parabola. */

static double at(size_t n, const struct sort *s, double im, double V)
{
    double all = 0;
    size_t i;
    for (i = 0; i < n; i++, s++) {
        double w = s->v - V;
        if (s->v > 0)
            all += s->left * w * w * s->m / (1 + s->m * im);
        else if (s->v < 0)
            all -= s->right * w * w * s->m / (1 + s->m * im);
    }
    return 2 * all;
}

double rain_force(size_t n, const struct sort rain[], double im, double V,
                  double *friction)
{
    *friction = (at(n, rain, im, -1) - at(n, rain, im, 1)) / 2;
    return at(n, rain, im, 0) - *friction * V;
}
