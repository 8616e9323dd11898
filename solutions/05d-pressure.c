/* Exercise 05d, worked: pressure from a list of wall hits.

   A disk that hits a wall with the component v comes back with -v, so the
   wall takes the momentum 2 m |v|. The sign of v says from which side, and
   a pressure does not care: without the absolute value left and right
   cancel. The momentum over the time is the force. It acts on two walls, on
   the left and on the right, so the length that counts for z[0] is twice
   the HEIGHT of the box; for z[1] it is twice the width.

   The time is that from `from` to `until`, no matter when the first and the
   last hit happened to be: the pauses before and after them are part of it.
   A hit at the very beginning does not count and one at the end does, so
   that two times which follow each other share out the hits: none is
   counted twice and none is lost.

   With walls no momentum is conserved, so that all 2 N components of
   velocity hold kT/2 each, and N kT is just the energy. Hence the number of
   disks cancels, and whoever has seen it may leave it out:
   z[k] = size[k] * (sum of m |v|) / (energy * time).

   Another way: the pressure on each wall by itself; then the mean of the
   two that face each other. They differ by chance, and by how much they do
   tells how well the pressure is known. */

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
    for (int k = 0; k < 2; ++k) {
        z[k] = momentum[k] / (until - from) / (2.0 * size[1 - k]);
        z[k] *= size[0] * size[1] / n_kT;
    }
}
