/* Exercise 09d. Ellipses, and kicks from the others (core, 30 minutes)

   Planets go round a Sun that stays where it is, at the origin. Each would
   go along an ellipse for ever, and a function that knows ellipses is
   given. Only the other planets disturb it. Write one step of Wisdom and
   Holman's method: half a kick, the drift, half a kick.

   Given:
     n     how many planets, 1 or more
     gm    gm[i] is the constant of gravity times the mass of planet i, in
           AU^3/d^2: at the distance r it gives others the acceleration
           gm[i]/r^2. It may be 0, for a body that is pulled and pulls none
     sun   the same for the Sun
     dt    the length of the step, in d; negative for a step back
     x, v  the places, in AU, and velocities, in AU/d, of the planets
   To be done: x and v become those after the step. First each velocity is
   changed by what the other planets do in half the step, then all planets
   go along their ellipses for a whole step, then come the other half kicks,
   from the new places.

   Check your answer with    make check EX=09d
   Hints, which ask before they tell:    make hint EX=09d */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

/* Given: moves one planet along its ellipse around the Sun for the time dt,
   as if nothing else were there. */
void drift(double sun, double dt, double x[3], double v[3]);

void ellipses_and_kicks(size_t n, const double gm[], double sun, double dt,
                        double x[][3], double v[][3])
{
    /* TODO: replace these lines by your own. Whose pull is in a kick, and
       whose is not? */
    (void)gm;
    (void)sun;
    (void)x;
    for (size_t i = 0; i < n; ++i)
        v[i][0] = NOT_DONE_YET(dt);
}
