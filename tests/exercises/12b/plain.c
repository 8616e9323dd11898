/* A right answer in plain C, with which wrong.diff begins. */

double apart(void (*step)(struct world w, double h, double *x, double *v),
             struct world w, double h, int n, double x, double v,
             double *end)
{
    double u = 0.7, y = x / u, z = v / u;
    struct world o;
    int i;
    o.g = w.g / u;
    o.k = w.k;
    o.q = w.q * u * u;
    for (i = 0; i < n; i++)
        step(w, h, &x, &v);
    for (i = 0; i < n; i++)
        step(o, h, &y, &z);
    *end = x;
    return fabs(x - y * u);
}
