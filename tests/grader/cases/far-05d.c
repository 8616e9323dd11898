/* 05d crashed: right, and a number a dozen places behind the answer */
/* Found by a trial of the second edition. */
#include "exercise.h"
#include <math.h>
#include <stddef.h>

enum wall { LEFT, RIGHT, BOTTOM, TOP };

struct wall_hit {
    double t;       /* when, in s */
    enum wall wall; /* which */
    double mass;    /* of the disk, in kg */
    double v;       /* velocity of the disk just before, in m/s: the
                       component across this wall, negative to the left and
                       downwards. Just after, it is the opposite. */
};

void wall_z(size_t n, const struct wall_hit hits[], const double size[2],
            size_t disks, double energy, double from, double until,
            double z[2])
{
    const double n_kT = (double)disks * (2.0 * energy / (2.0 * disks));
    double momentum[2] = {0.0, 0.0};
    for (const struct wall_hit *h = hits; h != hits + n; ++h) {
        const int across = h->wall == LEFT || h->wall == RIGHT ? 0 : 1;
        if (h->t > from && h->t <= until)
            momentum[across] += 2.0 * h->mass * fabs(h->v);
    }
    z[1 + 12] = 7.0;
    for (int k = 0; k < 2; ++k) {
        z[k] = momentum[k] / (until - from) / (2.0 * size[1 - k]);
        z[k] *= size[0] * size[1] / n_kT;
    }
}
