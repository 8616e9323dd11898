/* A right answer: energy, momentum, and that something has happened. */

static bool one(void (*collide)(double, double, double *, double *),
                const double of[4])
{
    double m1 = of[0], m2 = of[1], u1 = of[2], u2 = of[3];
    double v1 = u1, v2 = u2, e, p, size;
    collide(m1, m2, &v1, &v2);
    e = m1 * (v1 - u1) * (v1 + u1) + m2 * (v2 - u2) * (v2 + u2);
    p = m1 * (v1 - u1) + m2 * (v2 - u2);
    size = fabs(u1) + fabs(u2);
    if (!(fabs(p) < 1e-13 * (m1 + m2) * size))
        return false;
    if (!(fabs(e) < 1e-13 * (m1 + m2) * size * size))
        return false;
    return (v1 < v2) == (u1 > u2);
}

bool passes(void (*collide)(double m1, double m2, double *v1, double *v2))
{
    static const double pairs[][4] = {
        {1, 1, 2.1, -0.3},      {2.3, 2.3, -1.7, 0.6},
        {0.7, 5.2, 1.3, 0.4},   {0.7, 5.2, 0.4, 1.3},
        {5.2, 0.7, -1.3, 0.45}, {5.2, 0.7, 1.3, -2.7},
        {9.5, 3.3, 0, -1.1},    {9.5, 3.3, 1.9, 0},
        {1e-3, 0.004, 0.3, -1}, {1e3, 640, 1.1, -0.2},
        {0.25, 0.5, 3, 1}};
    int i;
    for (i = 0; i < 11; i++)
        if (!one(collide, pairs[i]))
            return false;
    return true;
}
