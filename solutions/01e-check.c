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

/* What is tried, each with each, and each with itself. Two have the same
   mass, two the same velocity, one is at rest, and the momenta of the
   second and the third cancel; one is the heaviest that was named, and one
   the lightest. */
static const struct {
    double m, v;
} body[] = {
    {1.0, 0.0}, {1.0, 1.37}, {0.5, -2.74}, {1e3, 1.37}, {1e-3, 7e4}};

enum { BODIES = sizeof body / sizeof *body };

static const double let_pass = 100.0 * DBL_EPSILON;

static bool is_nothing(double number, double size)
{
    return fabs(number) <= let_pass * size;
}

bool passes(void (*collide)(double m1, double m2, double *v1, double *v2))
{
    for (int i = BODIES; i-- > 0;)
        for (int j = BODIES; j-- > 0;) {
            const double m1 = body[i].m, m2 = body[j].m;
            const double u1 = body[i].v, u2 = body[j].v;
            double v1 = u1, v2 = u2;
            collide(m1, m2, &v1, &v2);
            const double fast = fabs(u1) + fabs(u2);
            if (!is_nothing(u1 - u2 + v1 - v2, fast) ||
                !is_nothing(m1 * (v1 - u1) + m2 * (v2 - u2),
                            (m1 + m2) * fast))
                return false;
        }
    return true;
}
