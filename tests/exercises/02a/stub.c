/* Exercise 02a. The next collision on a ring (warm-up, 15 minutes)

   Beads slide without friction on a wire that is bent to a closed ring. A
   bead that leaves at the length of the ring comes in again at 0. Each has
   a neighbour to its right, which it can run into: bead i has bead i + 1,
   and the last one has bead 0, across the seam. Two beads meet both ways
   round: each is the other's right neighbour. One bead alone meets nobody.
   The beads are points. Which two neighbours meet first, and when?

   Given:
     n        the number of beads, at least 1
     length   of the ring, once round, in m
     x        their positions in m, from 0 to below length, in the order of
              the ring: x[0] is the smallest. Only rounding may have put
              a bead a hair beyond its right neighbour.
     v        their velocities in m/s, of either sign, positive to the right
   To fill in:
     *left    the left one of the two that meet first: the bead whose right
              neighbour is the other. Where several pairs meet at the same
              time it is the smallest such number. Not asked for when
              no two ever meet.
   Returns the time until then, in s: INFINITY when no two ever meet, never
   less than 0. Two beads that touch, or that rounding has put in the wrong
   order, meet at once, after a time of 0, if they approach, and not at all
   if they do not.

   Check your answer with    make check EX=02a
   Hints, which ask before they tell:    make hint EX=02a */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

double next_meeting(size_t n, double length, const double x[],
                    const double v[], size_t *left)
{
    /* TODO: replace these lines by your own. For each bead: how far is it
       to the right neighbour, and how fast does that distance shrink? */
    (void)n;
    (void)x;
    (void)v;
    *left = 0;
    return NOT_DONE_YET(length);
}
