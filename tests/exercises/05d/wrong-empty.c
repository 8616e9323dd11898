/* mistake: nothing-over-nothing */

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
    double p[2] = {0, 0}, weight = 0, kT = energy / disks;
    size_t i;
    int k;
    for (i = 0; i < n; i++)
        if (hits[i].t > from && hits[i].t <= until) {
            p[hits[i].wall / 2] += 2 * hits[i].mass * fabs(hits[i].v);
            weight++;
        }
    for (k = 0; k < 2; k++) {
        double mean = p[k] / weight, rate = weight / (until - from);
        z[k] = mean * rate * size[k] / (2 * disks * kT);
    }
}
