/* A right answer: a unit that is longer than a metre, and the other run
   first. */

double apart(void (*step)(struct world w, double h, double *x, double *v),
             struct world w, double h, int n, double x, double v,
             double *end)
{
    double feet = 3.2808399;
    struct world f = w;
    double a = x * feet, b = v * feet;
    int i;
    f.g *= feet;
    f.q /= feet * feet;
    for (i = n; i; i--)
        step(f, h, &a, &b);
    for (i = n; i; i--)
        step(w, h, &x, &v);
    *end = x;
    return fabs(x - a / feet);
}
