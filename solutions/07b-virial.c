/* Exercise 07b, worked: pressure without walls.

   In the frame of the centre of mass either of the two is turned round
   along the line of centres. With the reduced mass m = m0 m1/(m0 + m1), the
   relative velocity w = v1 - v0, and the speed of approach u = -r.w/|r|,
   the momentum exchanged is J = 2 m u. What is summed is |r| J, and in this
   product the length of r drops out: it is -2 m r.w. So there is no root to
   be taken, and no direction to be divided by anything. When the two change
   places, r and w both change their signs, and the masses do not matter in
   which order they come: who is first is chance. For equal masses 2 m is
   the mass of one of them; no mean of two different ones will do.

   In Z the number of dimensions drops out too: D kT is 2 K/(n - 1). It is
   needed all the same, to know how many components a vector has, and for kT
   in the pressure.

   Z - 1 is small in a thin gas and is not lost there: it is summed up by
   itself, and all its terms are positive.

   Another way: let the two collide and take the change of the momentum of
   one of them. It is along the line of centres, so its length times |r| is
   what is summed; this way holds for any law of collision. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

struct collision {
    double mass[2];   /* kg */
    double apart[3];  /* from the first to the second at contact, m */
    double first[3];  /* velocity of the first just before, m/s */
    double second[3]; /* and of the second */
};

/* The momentum exchanged, times the distance that it jumps. */
static double jump(const struct collision *c, int dimensions)
{
    double closing = 0.0;
    for (int k = dimensions; k-- > 0;)
        closing += (c->first[k] - c->second[k]) * c->apart[k];
    return 2.0 * closing / (1.0 / c->mass[0] + 1.0 / c->mass[1]);
}

double compressibility(int dimensions, const double box[3], size_t n,
                       double energy, double time, size_t count,
                       const struct collision collisions[],
                       double *pressure)
{
    const double moving = (double)n - 1.0;
    const double third = dimensions > 2 ? box[2] : 1.0;
    double virial = 0.0;
    const struct collision *c = collisions;
    while (c < collisions + count)
        virial += jump(c++, dimensions);
    const double z = 1.0 + virial * moving / (2.0 * energy * n * time);
    *pressure = z * n * 2.0 * energy /
                (dimensions * moving * box[0] * box[1] * third);
    return z;
}
