/* A right answer: the rest of the time, walked from wall to wall; qsort. */

#include <stdlib.h>

struct ghost {
    double x, v;
};

static int from_left(const void *one, const void *other)
{
    double a = ((const struct ghost *)one)->x;
    double b = ((const struct ghost *)other)->x;
    return (a > b) - (a < b);
}

static struct ghost walk(double x, double v, double length, double t)
{
    struct ghost g = {x, v};
    double left = v == 0 ? 0 : fmod(t, 2 * length / fabs(v));
    for (;;) {
        double wall = g.v > 0 ? length : 0;
        double need = g.v == 0 ? INFINITY : (wall - g.x) / g.v;
        if (need > left)
            break;
        left -= need;
        g.x = wall;
        g.v = -g.v;
    }
    g.x += g.v * left;
    return g;
}

void positions_at(size_t n, double length, const double x0[],
                  const double v0[], double t, double x[], double v[])
{
    struct ghost *g = malloc(n * sizeof *g);
    size_t i;
    for (i = 0; g && i < n; i++)
        g[i] = walk(x0[i], v0[i], length, t);
    if (g)
        qsort(g, n, sizeof *g, from_left);
    for (i = 0; g && i < n; i++) {
        const struct ghost *one = g + i;
        x[i] = one->x;
        v[i] = one->v;
    }
    free(g);
}
