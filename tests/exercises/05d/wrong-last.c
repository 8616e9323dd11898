/* mistake: first-hit-to-last */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

enum wall { LEFT, RIGHT, BOTTOM, TOP };

struct wall_hit {
    double t;
    enum wall wall;
    double mass, v;
};

void wall_z(size_t n, const struct wall_hit hits[], const double size[2],
            size_t disks, double energy, double from, double until,
            double z[2])
{
    double p[2] = {0, 0}, kT = energy / disks, time;
    size_t i;
    int k;
    while (n > 0 && hits[n - 1].t > until)
        n--;
    while (n > 0 && hits[0].t <= from) {
        n--;
        hits++;
    }
    time = n > 1 ? hits[n - 1].t - hits[0].t : 1;
    for (i = 0; i < n; i++)
        p[hits[i].wall / 2] += 2 * hits[i].mass * fabs(hits[i].v);
    for (k = 0; k < 2; k++)
        z[k] = p[k] / time * size[k] / (2 * disks * kT);
}
