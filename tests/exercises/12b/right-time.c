/* A right answer: yards and a second of another length, step by step beside
   the first run. */

double apart(void (*step)(struct world w, double h, double *x, double *v),
             struct world w, double h, int n, double x, double v,
             double *end)
{
    double yard = 0.9144, beat = 1.1;
    double y = x / yard, u = v / yard * beat;
    struct world o;
    int i;
    o.g = w.g / yard * beat * beat;
    o.k = w.k * beat * beat;
    o.q = w.q * yard * beat * yard * beat;
    for (i = 0; i < n; i++) {
        step(w, h, &x, &v);
        step(o, h / beat, &y, &u);
    }
    *end = x;
    return y * yard > x ? y * yard - x : x - y * yard;
}
