/* Exercise 11c. Going back (core, 35 minutes)

   After a step two spheres overlap. They should have collided on the way,
   and flown on with their new velocities. When was that, and where would
   they be now?

   Given:
     a, b  the two spheres: their inverse masses, in 1/kg, of which one may
           be 0, their radii, in m, places, in m, and velocities, in m/s
     dt    how long the step was, in s
   To be done: the spheres go back in time, with the velocities they have,
   until they just touch. There they collide elastically; no force acts
   along the surface. Then they fly on for as long as they went back. Both
   get their new places and velocities.
   Returns how long ago they touched, in s. Nothing is changed, and -1 is
   returned, when they do not overlap, when they do not approach, and when
   they touched more than dt ago: then they did not come there by flying.

   Check your answer with    make check EX=11c
   Hints, which ask before they tell:    make hint EX=11c */

#include "exercise.h"
#include <math.h>

struct sphere {
    double im, r, x[3], v[3];
};

double go_back(struct sphere *a, struct sphere *b, double dt)
{
    /* TODO: replace these lines by your own. Where was b, as seen from a,
       a time t ago? When was it as far away as the two radii? */
    (void)b;
    a->x[0] += a->v[0] * dt;
    return NOT_DONE_YET(dt);
}
