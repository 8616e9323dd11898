/* Exercise 02c. A million seconds, no collision (stretch, 30 minutes)

   Points of equal mass move on a line between two walls, at 0 and at
   length. They collide with each other and with the walls, and no energy is
   lost. After a million seconds they have collided millions of times. Where
   is each of them then? You need not compute one collision: bodies of
   equal mass exchange their velocities, so draw the paths of two that meet.
   What would the drawing look like if they had passed through each other?

   Given:
     n           the number of bodies, at least 1
     length      the distance between the walls, in m
     x0          the positions at time 0 from left to right, in m, no two
                 the same, all between the walls
     v0          the velocities at time 0, in m/s, positive to the right
     t           the time at which we look, in s, not negative; nobody
                 touches a wall or a neighbour just then
   To fill in:
     x, v        position and velocity of each body at the time t: x[k] and
                 v[k] belong to the body that began at x0[k] with v0[k]
   A position may be wrong by 4 DBL_EPSILON (length + speed t), where speed
   is the largest one; a velocity is exact.

   Check your answer with    make check EX=02c
   Hints, which ask before they tell:    make hint EX=02c */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

void positions_at(size_t n, double length, const double x0[],
                  const double v0[], double t, double x[], double v[])
{
    /* TODO: replace these lines by your own. Where is a body that meets
       nothing but the walls? And whose place is that? */
    (void)(length + t);
    for (size_t k = 0; k < n; ++k) {
        x[k] = NOT_DONE_YET(x0[k]);
        v[k] = v0[k];
    }
}
