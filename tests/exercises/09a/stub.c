/* Exercise 09a. The potential of the softened force (warm-up, 20 minutes)

   Bodies attract each other with a softened force: body i is accelerated
   by every other body j as
       k2 m_j (x_j - x_i) / (r^2 + softening^2)^(3/2),
   where r is the distance of the two. Who wants to see whether the energy
   is conserved needs the potential that goes with THIS force: minus its
   gradient is the force. Far away from all bodies it is zero.

   Given:
     n          how many bodies there are; there may be none
     mass       their masses, in kg
     x          where they are, in m: first the x of all bodies, then the y
                of all, then the z of all. Coordinate k of body i is at
                x[k * n + i].
     k2         the constant of gravity, in m^3/(kg s^2)
     softening  in m; it may be 0, and then no two bodies are at the same
                place
   To fill in:
     potential  potential[i] is that of all OTHER bodies at the place of
                body i, for each kilogram there: in m^2/s^2
   Returns the potential energy of all bodies together, in J. A pair of them
   has one energy.

   Check your answer with    make check EX=09a
   Hints, which ask before they tell:    make hint EX=09a */

#include "exercise.h"
#include <stddef.h>

double potential_energy(size_t n, const double mass[], const double x[],
                        double k2, double softening, double potential[])
{
    /* TODO: replace these lines by your own. Of which function of r is the
       force of one body the derivative? */
    (void)mass;
    (void)x;
    (void)k2;
    for (size_t i = 0; i < n; ++i)
        potential[i] = NOT_DONE_YET(0.0);
    return NOT_DONE_YET(softening);
}
