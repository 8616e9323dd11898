/* Exercise 04a, worked: springs of air.

   When a gas of the length l grows by dl, it gives the work 2 K dl / (f l)
   to the piston and its energy falls by as much:
       dK / K = -(2/f) dl / l.
   So K l^(2/f) stays what it is. On a line, f = 1, that is the K l^2 of the
   book. In the room, f = 3, squeezing the gas to half its length makes K
   larger by 1.6 instead of 4: the energy goes into directions that do not
   push the piston back. The spring is softer.

   Both gases were given with the piston in the middle, at half the length
   of the box. By now the left one is x long and the right one length - x.
   The left one pushes to the right, the right one to the left. What must
   be moved is the piston and a third of the gas: the gas at the wall rests,
   that at the piston moves with it, and between them the velocity grows
   evenly; the mean of its square is a third.

   In C, 2/f with an int f is a whole number, and 0 for f = 3. Hence 2.0.

   Another way: the textbooks' pressure times volume to the power gamma,
   with gamma = 1 + 2/f. Or write down the stored energy K_L + K_R as a
   function of x and take its slope: the exponent 2/f comes down and is the
   factor in the force. Each derives the other. */

#include "exercise.h"
#include <math.h>

/* The push of a gas of the length now, whose energy is known at another. */
static double push(int f, double known, double at, double now)
{
    const double energy = known * pow(at / now, 2.0 / f);
    return 2.0 / f * energy / now;
}

void piston_slopes(int f, double length, double mass, double gas,
                   const double energy[2], const double state[2],
                   double slope[2])
{
    const double half = 0.5 * length, x = state[0];
    const double from_left = push(f, energy[0], half, x);
    const double from_right = push(f, energy[1], half, length - x);
    slope[0] = state[1];
    slope[1] = (from_left - from_right) / (mass + gas / 3.0);
}
