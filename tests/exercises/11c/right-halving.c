/* A right answer: the moment is found by halving the step, and the impulse
   from the energy in the frame of the centre of mass. */

static double gap(const struct sphere *a, const struct sphere *b, double t)
{
    double s = 0;
    int k;
    for (k = 0; k < 3; k++)
        s += pow(b->x[k] - t * b->v[k] - a->x[k] + t * a->v[k], 2);
    return sqrt(s) - a->r - b->r;
}

double go_back(struct sphere *a, struct sphere *b, double dt)
{
    double early = 0, late = dt, t, n[3], in = 0;
    int k;
    for (k = 0; k < 3; k++)
        in += (b->x[k] - a->x[k]) * (b->v[k] - a->v[k]);
    if (gap(a, b, 0) >= 0 || in >= 0 || gap(a, b, dt) < 0)
        return -1;
    for (k = 0; k < 100; k++) {
        t = (early + late) / 2;
        if (gap(a, b, t) < 0)
            early = t;
        else
            late = t;
    }
    t = (early + late) / 2;
    in = 0;
    for (k = 0; k < 3; k++) {
        n[k] =
            (b->x[k] - t * b->v[k] - a->x[k] + t * a->v[k]) / (a->r + b->r);
        in += n[k] * (b->v[k] - a->v[k]);
    }
    for (k = 0; k < 3; k++) {
        double da = 2 * in * a->im / (a->im + b->im) * n[k];
        double db = -2 * in * b->im / (a->im + b->im) * n[k];
        a->v[k] += da;
        a->x[k] += t * da;
        b->v[k] += db;
        b->x[k] += t * db;
    }
    return t;
}
