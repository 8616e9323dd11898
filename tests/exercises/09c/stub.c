/* Exercise 09c. Kepler's equation (core, 30 minutes)

   Where is a planet at a given time? Its mean anomaly M grows evenly, by
   2 pi in a period, and is 0 where the planet is nearest to the sun. Its
   place is known when its eccentric anomaly E is: Kepler's equation
       E - e sin(E) = M
   has exactly one solution, and no formula for it.

   Given:
     e        the eccentricity of the ellipse, from 0 to below 1
     mean     M, in radians, of either sign, and it may be of many periods
   Returns
     E, in radians, and in the same revolution: E - M is nowhere larger than
     e in absolute value.

   The result must be as good as rounding allows. The equation itself can be
   computed to a few epsilons of 1 + |M|, and 1/(1 - e cos(E)) says how far
   that moves the solution: 8 epsilons of it are let pass.

   Check your answer with    make check EX=09c
   Hints, which ask before they tell:    make hint EX=09c */

#include "exercise.h"

double eccentric_anomaly(double e, double mean)
{
    /* TODO: replace these lines by your own. Between which two numbers does
       E lie? */
    (void)e;
    return NOT_DONE_YET(mean);
}
