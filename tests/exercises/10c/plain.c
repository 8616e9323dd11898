/* A right answer in plain C, with which wrong.diff begins. */

double membrane_modes(const struct grid *g, double omega[])
{
    double pi = 4 * atan(1), a, b, w = 0, most = 0, least = INFINITY;
    double kx = g->stiffness * (g->dx - g->restx) / g->dx;
    double ky = g->stiffness * (g->dy - g->resty) / g->dy;
    int r, s;
    for (s = 1; s < g->ny - 1; s++)
        for (r = 1; r < g->nx - 1; r++) {
            a = 4 * pow(sin(r * pi / 2 / (g->nx - 1)), 2);
            b = 4 * pow(sin(s * pi / 2 / (g->ny - 1)), 2);
            w = (kx * a + ky * b) / g->mass;
            w = w < 0 ? -sqrt(-w) : sqrt(w);
            omega[(s - 1) * (g->nx - 2) + r - 1] = w;
            if (w > most)
                most = w;
            if (w > 0 && w < least)
                least = w;
        }
    (void)least;
    return 2 / most;
}
