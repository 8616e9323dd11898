/* A right answer: back, collide, forward, one after the other. */

static double along(const double *p, const double *q)
{
    double sum = *p * *q;
    sum += p[1] * q[1];
    return sum + p[2] * q[2];
}

double go_back(struct sphere *a, struct sphere *b, double dt)
{
    double d[3], u[3], n[3], s = a->r + b->r, uu, du, dd, t, p;
    int k;
    for (k = 0; k < 3; k++) {
        d[k] = -(a->x[k] - b->x[k]);
        n[k] = d[k];
        u[k] = b->v[k];
        u[k] -= a->v[k];
    }
    uu = along(u, u);
    du = along(d, u);
    dd = along(d, d);
    t = (du + sqrt(du * du + uu * (s * s - dd))) / uu;
    if (dd >= s * s || du >= 0 || !(t <= dt))
        return -1;
    for (k = 0; k < 3; k++) {
        a->x[k] -= t * a->v[k];
        b->x[k] -= t * b->v[k];
        n[k] = b->x[k] - a->x[k];
    }
    p = 2 * along(n, u) / along(n, n) / (a->im + b->im);
    for (k = 0; k < 3; k++) {
        a->v[k] += p * a->im * n[k];
        b->v[k] -= p * b->im * n[k];
        a->x[k] += t * a->v[k];
        b->x[k] += t * b->v[k];
    }
    return t;
}
