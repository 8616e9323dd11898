/* A right answer in plain C, with which wrong.diff begins. */

static double growth(double h)
{
    double p[2] = {1, 0}, q[2] = {0, 1}, t, d, u;
    step(h, p);
    step(h, q);
    t = p[0] + q[1];
    d = p[0] * q[1] - p[1] * q[0];
    u = t * t - 4 * d;
    if (u < 0)
        return sqrt(d);
    return (fabs(t) + sqrt(u)) / 2;
}

static int bad(double h)
{
    return growth(h) > 1 + 1e-11;
}

double stability_limit(double most)
{
    double a, b, c;
    int i;
    for (i = 1; i * 0.01 <= most && !bad(i * 0.01); i++)
        continue;
    if (i * 0.01 > most)
        return INFINITY;
    if (i == 1)
        return 0;
    a = (i - 1) * 0.01;
    b = i * 0.01;
    while (b - a > 5e-11) {
        c = (a + b) / 2;
        if (bad(c))
            b = c;
        else
            a = c;
    }
    return a;
}
