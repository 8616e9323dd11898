/* Exercise 01e, worked: CHECKcollide.

   Momentum, and what else? Energy, says everybody; but who does nothing
   keeps both. On a line two equations of which one is a square have two
   solutions, and to miss each other is the second. So ask for something
   that has a sign: the velocity of approach becomes one of departure, just
   as large. With the momentum this is all that an elastic collision is, and
   the energy follows. Nothing is left over to be wrong in.

   Which collisions? General ones, of which the suspect cannot be right by
   accident: no whole numbers, either mass the heavier, either body the
   faster, from either side. And the special cases, for these are where
   programmers write an "if": equal masses, a body at rest, equal
   velocities, head on with no momentum at all.

   How near? What is compared was computed with a few roundings of the
   larger terms. So the largest momentum is the measure, not the sum, which
   may be zero. 100 epsilons are more than what a right one can lose, and a
   million times less than a float loses. Ask "is it within", not "is it
   beyond": a NaN is neither.

   Another way: work out what must come out, and compare. That is a check,
   too, if one does not share the mistake. */

#include "exercise.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

static bool near(double a, double b, double size)
{
    return fabs(a - b) <= 100.0 * DBL_EPSILON * size;
}

bool passes(void (*collide)(double m1, double m2, double *v1, double *v2))
{
    static const double mass[] = {1.0, 0.0123, 1.0, 3.7, 456.7},
                        velocity[] = {0.0, 1.37, -2.9, 1.37, 0.011};
    for (int k = 0; k < 5 * 5 * 5 * 5; ++k) {
        const double m1 = mass[k % 5], m2 = mass[k / 5 % 5];
        const double u1 = velocity[k / 25 % 5], u2 = velocity[k / 125];
        double v1 = u1, v2 = u2;
        collide(m1, m2, &v1, &v2);
        const double fast = fabs(u1) + fabs(u2);
        if (!near(u1 - u2, v2 - v1, fast) ||
            !near(m1 * u1 + m2 * u2, m1 * v1 + m2 * v2, (m1 + m2) * fast))
            return false;
    }
    return true;
}
