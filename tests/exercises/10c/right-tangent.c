/* A right answer: the sines of one axis after the other, from the last
   mode to the first, and the highest frequency on its own. */

#include <stdlib.h>

static void axis(int n, double k, double q[])
{
    for (int i = n - 2; i > 0; i--) {
        double t = tan(i * atan(1) / (n - 1));
        q[i] = k * pow(4 * t / (1 + t * t), 2);
    }
}

double membrane_modes(const struct grid *g, double omega[])
{
    double *a = malloc(g->nx * sizeof *a), *b = malloc(g->ny * sizeof *b);
    double most = 0;
    if (a && b) {
        axis(g->nx, g->stiffness / g->mass * (1 - g->restx / g->dx), a);
        axis(g->ny, g->stiffness / g->mass * (1 - g->resty / g->dy), b);
        for (int i = (g->nx - 2) * (g->ny - 2) - 1; i >= 0; i--) {
            double w = a[i % (g->nx - 2) + 1] + b[i / (g->nx - 2) + 1];
            if (w > most)
                most = w;
            omega[i] = w < 0 ? -sqrt(-w) : sqrt(w);
        }
    }
    free(a);
    free(b);
    return 2 / sqrt(most);
}
