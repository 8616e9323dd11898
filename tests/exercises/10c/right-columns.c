/* A right answer: column by column, with a step for each mode and the
   smallest of them kept. */

double membrane_modes(const struct grid *g, double omega[])
{
    double step = INFINITY, t[2];
    int r, s;
    t[0] = (g->dx - g->restx) * g->stiffness / g->dx / g->mass;
    t[1] = (g->dy - g->resty) * g->stiffness / g->dy / g->mass;
    for (r = 1; r < g->nx - 1; r++) {
        double across = asin(1) * r / (g->nx - 1);
        for (s = 1; s < g->ny - 1; s++) {
            double along = asin(1) * s / (g->ny - 1), w;
            w = t[0] * pow(sin(across), 2) + t[1] * pow(sin(along), 2);
            w = w > 0 ? 2 * sqrt(w) : -2 * sqrt(-w);
            if (w > 0 && 2 / w < step)
                step = 2 / w;
            omega[(s - 1) * (g->nx - 2) + r - 1] = w;
        }
    }
    return step;
}
