/* mistake: one-falls */

#include "exercise.h"
#include <math.h>

struct thrown {
    double x, y, vx, vy, radius;
};

double falling_pair_time(double g, const struct thrown *a,
                         const struct thrown *b, double *height)
{
    double x = b->x - a->x, y = b->y - a->y;
    double vx = b->vx - a->vx, vy = b->vy - a->vy;
    double s = a->radius + b->radius, step = 1e-3, t = 0;
    double p = x * vx + y * vy, nearer;
    if (hypot(x, y) <= s)
        return p < 0 ? 0 : INFINITY;
    while (step > 1e-15) {
        nearer = t + step;
        if (nearer > 10)
            return INFINITY;
        if (hypot(x + vx * nearer,
                  y + vy * nearer - g * nearer * nearer / 2) <= s)
            step /= 2;
        else
            t = nearer;
    }
    *height = a->y + a->vy * t;
    return t;
}
