/* Exercise 01b. Weighing without a balance (core, 20 minutes)

   Two bodies on a line have collided, and a camera has measured the four
   velocities: before and after, of either body. Both may have been moving
   before, and energy may have been lost. Which body is the heavier, and by
   what factor? And how well did they bounce?

   Given:
     u1, u2         the velocities before, in m/s, positive to the right
     v1, v2         the velocities after, in m/s
   To fill in:
     *mass_ratio    m1/m2: the first mass divided by the second, a number
                    from 0 (the second body is a wall) to INFINITY (the
                    first one is)
     *restitution   the speed at which they separate divided by the speed
                    at which they approached
   Returns true when the four velocities could tell, and false when no
   collision can have given them or none took place: when the two moved
   alike before, when neither velocity has changed, or when the mass ratio
   would have to be negative. What stands in *mass_ratio and *restitution
   then does not matter. Whether the restitution lies between 0 and 1 is
   not asked.

   Check your answer with    make check EX=01b
   Hints, which ask before they tell:    make hint EX=01b */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution)
{
    /* TODO: replace these lines by your own. What do the laws that gave the
       velocities from the masses say when the velocities are known? */
    (void)(u1 + u2 + v1 + v2);
    *mass_ratio = NOT_DONE_YET(1.0);
    *restitution = NOT_DONE_YET(1.0);
    return true;
}
