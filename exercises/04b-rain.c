/* Exercise 04b. One blow at a time (core, 25 minutes)

   Particles rain on a wall from both sides, and the wall moves. Each blow
   is a collision; so many come in a second. Which force do they make up,
   and how much of it is friction?

   Given:
     n        how many sorts of particles there are
     rain     the sorts: the mass of a particle, in kg, its velocity, in
              m/s, positive to the right, and how many of them there are in
              a metre to the left of the wall, and in a metre to its right.
              Particles do not meet each other, and none comes back.
     im       the inverse mass of the wall, in 1/kg; 0 if no blow moves it.
              Between two blows something brings its velocity back to V.
     V        the velocity of the wall, in m/s: small compared with those of
              all particles, but for the ones at rest, if there are any
   To fill in:
     *friction  by how much the force falls for each m/s of V, in kg/s
   Returns the mean force on the wall, in N, positive to the right, to first
   order in V: what has V^2 in it is left out.

   Check your answer with    make check EX=04b
   Hints, which ask before they tell:    make hint EX=04b */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

struct sort {
    double m, v;        /* in kg and m/s */
    double left, right; /* in 1/m: how many, on this side of the wall */
};

double rain_force(size_t n, const struct sort rain[], double im, double V,
                  double *friction)
{
    /* TODO: replace these lines by your own. What does one blow give to the
       wall, how many come in a second, and which of the two knows V? */
    (void)n;
    (void)rain;
    (void)im;
    *friction = NOT_DONE_YET(V);
    return V;
}
