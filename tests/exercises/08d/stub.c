/* Exercise 08d. Find a stability limit (core, 30 minutes)

   A method is given as a black box: one step of an oscillator, and nobody
   says which method and which frequency. How large may the step be before
   the oscillator blows up?

   step(), which the check provides, makes one step of the length h: y[0]
   is the coordinate in m and y[1] its velocity in m/s. It is linear: what
   it makes of a sum is the sum of what it makes of the parts. So two calls
   with the same h say all about it. Step after step the oscillator stays
   bounded when no eigenvalue of that 2 by 2 matrix, real or complex, is
   larger than 1 in absolute value. For rounding, let 1 + 1e-11 pass.

   Given:
     most     the largest step that is of interest, in s, at least 0.01
   Returns
     the limit, in s: try the steps 0.01 s, 0.02 s, ... up to `most`. The
     limit lies between the first one that is not stable and the one
     before it; bring its two sides together until they are less than
     1e-10 s apart. Beyond the limit there may be other stable steps: they
     do not matter;
     0 when 0.01 s is not stable: of such a method nobody wants more;
     INFINITY when all these steps are stable.

   Check your answer with    make check EX=08d
   Hints, which ask before they tell:    make hint EX=08d */

#include "exercise.h"

void step(double h, double y[2]);

double stability_limit(double most)
{
    /* TODO: replace this line by your own. What does a step make of (1, 0),
       and what of (0, 1)? */
    return NOT_DONE_YET(most);
}
