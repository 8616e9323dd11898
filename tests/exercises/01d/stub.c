/* Exercise 01d. Taking aim (stretch, 40 minutes)

   A smooth disk slides along a straight line towards another one, which is
   at rest. The line passes the centre of the disk at rest at a distance b,
   the impact parameter: b = 0 is a blow head-on, and for b > r1 + r2 the
   disks miss. They collide and no energy is lost. By what angle is the
   first disk turned from its way? That is the easy question. Here the
   angle is wanted, and you take the aim.

   Given:
     r1, r2      the radii of the moving disk and of the disk at rest, in m
     im1, im2    their inverse masses, in 1/kg; im1 > 0, and im2 = 0 is a
                 disk that nothing moves
     deflection  the angle between the first disk's velocities before and
                 after, in radians: from 0 (straight on) to pi (back)
   Returns the impact parameter b, in m, from 0 to r1 + r2, for which the
   first disk is turned by just that angle; the LARGER one where two of them
   do it; and -1 where none does.

   Check your answer with    make check EX=01d
   Hints, which ask before they tell:    make hint EX=01d */

#include "exercise.h"

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection)
{
    /* TODO: replace these lines by your own. A drawing comes first: where
       are the centres when the disks touch, and along which line do they
       push each other? */
    (void)r1;
    (void)r2;
    (void)im1;
    (void)im2;
    return NOT_DONE_YET(deflection);
}
