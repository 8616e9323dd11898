/* A right answer in plain C, with which wrong.diff begins. */

double dashpot(double c, const struct body *a, const struct body *b,
               double on_a[3], double on_b[3])
{
    double d[3], u[3], r = 0, uu = 0, ud = 0, s;
    int k;
    for (k = 0; k < 3; k++) {
        d[k] = b->x[k] - a->x[k];
        u[k] = b->v[k] - a->v[k];
        r += d[k] * d[k];
        uu += u[k] * u[k];
        ud += u[k] * d[k];
    }
    r = sqrt(r);
    s = r > 0 ? ud / r : 0;
    for (k = 0; k < 3; k++) {
        double n = r > 0 ? d[k] / r : 0;
        on_a[k] = c * s * n;
        on_b[k] = -c * s * n;
    }
    (void)uu;
    return c * s * s;
}
