/* mistake: second-at-rest */

bool passes(void (*collide)(double m1, double m2, double *v1, double *v2))
{
    static const double t[][4] = {
        {1, 1, 2.1, 0}, {0.7, 5.2, 1.3, 0}, {5.2, 0.7, -1.3, 0}};
    unsigned i;
    for (i = 0; i < sizeof t / sizeof t[0]; i++) {
        double m = t[i][0], n = t[i][1], u = t[i][2], w = t[i][3];
        double a = u, b = w, p, e, d, big = fabs(u) + fabs(w);
        collide(m, n, &a, &b);
        p = (m * (a - u) + n * (b - w)) / (m + n) / big;
        e = (m * (a * a - u * u) + n * (b * b - w * w)) / (m + n) / big /
            big;
        d = (u - w + a - b) / big;
        (void)e;
        if (!(fabs(p) < 1e-12) || !(fabs(d) < 1e-12))
            return false;
    }
    return true;
}
