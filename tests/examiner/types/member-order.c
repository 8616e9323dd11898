/* 05d does not build: the walls have another order, which gives them other numbers */
/* says: .c:8:6: error: members changed in 'enum */
/* says: enum wall has other members than the exercise gave: enum wall { LEFT, RIGHT, BOTTOM, TOP } */
#include "exercise.h"
#include <math.h>
#include <stddef.h>

enum wall { BOTTOM, TOP, LEFT, RIGHT };

struct wall_hit {
    double t;
    enum wall wall;
    double mass, v;
};

void wall_z(size_t n, const struct wall_hit hits[], const double size[2],
            size_t disks, double energy, double from, double until,
            double z[2])
{
    (void)disks;
    z[0] = z[1] = 0;
    for (size_t i = 0; i < n; ++i)
        if (hits[i].t > from && hits[i].t <= until)
            z[hits[i].wall < LEFT] += hits[i].mass * fabs(hits[i].v);
    for (int k = 0; k < 2; ++k)
        z[k] *= size[k] / (energy * (until - from));
}
