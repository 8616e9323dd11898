/* Without a root: both eigenvalues of l^2 - T l + D lie within a circle of
   the radius r if D <= r^2 and |T| r <= r^2 + D. Halving is recursive. */

static int good(double h)
{
    const double r = 1 + 1e-11;
    double m[4] = {1, 0, 0, 1};
    step(h, m);
    step(h, m + 2);
    const double t = fabs(m[0] + m[3]), d = m[0] * m[3] - m[1] * m[2];
    return d <= r * r && t * r <= r * r + d;
}

static double between(double a, double b)
{
    const double c = a + (b - a) / 2;
    if (b - a < 1e-10)
        return c;
    return good(c) ? between(c, b) : between(a, c);
}

double stability_limit(double most)
{
    for (long i = 1; i * 0.01 <= most; i++)
        if (!good(i * 0.01))
            return i == 1 ? 0 : between((i - 1) * 0.01, i * 0.01);
    return HUGE_VAL;
}
