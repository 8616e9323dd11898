/* Exercise 12d. Is this scene one-dimensional? (core, 25 minutes)

   On a line, bodies can be computed a great deal faster than in space. A
   scene that was drawn in space may live on a line all the same: on an
   axis, or on any other. But it must do so exactly. A velocity of a
   billionth of a metre per second out of the line grows, and in the end the
   bodies miss each other. So all numbers here are whole numbers of
   nanometres and seconds, from -1000000000 to 1000000000, and there is no
   rounding to hide behind.

   Given:
     n        how many bodies there are; there may be none
     body     where they are, and how fast they go
     weight   the acceleration that all of them have; (0, 0, 0) for none.
              All other forces act along the lines from body to body.
   To fill in:
     along    a vector along the line, of any length and in either
              direction, but not (0, 0, 0). Only where every line through
              the bodies will do it is to be (0, 0, 0): all are at one place
              and at rest, and without weight. When there is no line, what
              is in it does not matter.
   Returns whether there is a straight line which does not move and which
   the bodies never leave: all of them are on it now, and their velocities
   and the weight point along it.

   Check your answer with    make check EX=12d
   Hints, which ask before they tell:    make hint EX=12d */

#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>

struct body {
    int x[3]; /* its place, in nm */
    int v[3]; /* its velocity, in nm/s */
};

bool one_line(size_t n, const struct body body[], const int weight[3],
              int along[3])
{
    /* TODO: replace these lines by your own. Which vectors must be parallel
       to each other? And how does one see that without dividing? */
    (void)n;
    (void)body;
    (void)weight;
    along[0] = along[1] = along[2] = NOT_DONE_YET(0);
    return false;
}
