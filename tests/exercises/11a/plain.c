/* A right answer in plain C, with which wrong.diff begins. */

double part_spheres(struct sphere *a, struct sphere *b)
{
    double d[3], r = 0, h, p, q, s = a->radius + b->radius;
    double m = a->mass, M = b->mass;
    int i;
    for (i = 0; i < 3; i++) {
        d[i] = b->x[i] - a->x[i];
        r += d[i] * d[i];
    }
    r = sqrt(r);
    h = s - r;
    if (h <= 0)
        return 0;
    if (r == 0)
        d[0] = r = 1;
    if (isinf(m) || isinf(M)) {
        p = isinf(m) ? 0 : 1;
        q = 1 - p;
    } else {
        p = M / (m + M);
        q = m / (m + M);
    }
    for (i = 0; i < 3; i++) {
        a->x[i] -= p * h * d[i] / r;
        b->x[i] += q * h * d[i] / r;
    }
    return h;
}
