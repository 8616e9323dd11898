/* Exercise 01e. CHECKcollide (core, 30 minutes)

   Somebody hands you a function that claims to collide two bodies on a
   line, elastically. Is it right? You cannot read it; you can only call it.

   Given:
     collide  collide(m1, m2, &v1, &v2) takes two masses, in kg, from 1e-3
              to 1e3, and replaces the velocities before, in m/s, by those
              after. The two do meet: which of them comes from the left is
              not said, and a right function does not ask.
   Returns true if it is right, as far as you can find out, and false if it
   is not. A right one rounds: its velocities may be wrong by ten epsilons
   (DBL_EPSILON) of the fastest, before or after. Everything larger is a
   mistake. So are a NaN, and a function that is only right for some masses
   or velocities.

   You earn points for each wrong function that you refuse, and none if you
   refuse a right one.

   Check your answer with    make check EX=01e
   Hints, which ask before they tell:    make hint EX=01e */

#include "exercise.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>

bool passes(void (*collide)(double m1, double m2, double *v1, double *v2))
{
    /* TODO: replace these lines by your own. Which collisions would you let
       it compute, and what must be true of what comes out? */
    double v1 = 1.0, v2 = 0.0;
    collide(1.0, 1.0, &v1, &v2);
    return NOT_DONE_YET(true);
}
