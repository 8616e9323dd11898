/* A right answer: other units in every call, from 3 m and 7 s (which lost
   points in a trial of the second edition) to those of atoms and of
   planets. */

static const double units[][2] = {
    {3.0, 7.0},     {0.9144, 60.0},   {0.3048, 1.0},
    {1.0, 0.7},     {1609.344, 3600}, {149597870700, 86400.0},
    {1e-10, 1e-15}, {1.5, 1.0},       {2.0, 3.0},
    {1.0, 60.0},    {1.001, 1.0},     {5.0, 0.25},
};

double apart(void (*step)(struct world w, double h, double *x, double *v),
             struct world w, double h, int n, double x, double v,
             double *end)
{
    static int calls;
    const double *unit = units[calls++ % (sizeof units / sizeof *units)];
    double y = x / unit[0], u = v / unit[0] * unit[1];
    struct world o;
    o.g = w.g / unit[0] * unit[1] * unit[1];
    o.k = w.k * (unit[1] * unit[1]);
    o.q = w.q * unit[0] * unit[0] * (unit[1] * unit[1]);
    for (int i = n; i-- > 0; step(o, h / unit[1], &y, &u))
        step(w, h, &x, &v);
    *end = x;
    return fabs(y * unit[0] - x);
}
