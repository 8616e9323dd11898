/* Exercise 05a. The time to a round wall (warm-up, 20 minutes)

   A disk flies freely, without forces, in a round box on an air table. The
   origin is the centre of the box. When does the disk touch the wall?

   Given:
     box      the radius of the box, in m
     radius   of the disk, in m, smaller than that of the box
     r        where the centre of the disk is: r[0] across and r[1] up,
              in m. The disk is in the box and may touch the wall; only
              rounding may have put it a hair beyond.
     v        its velocity, likewise, in m/s: zero, or 1e-9 m/s and more
   Returns the time until the disk comes to the wall, in s, never less than
   0. A disk that touches the wall and moves outwards comes to it now, after
   a time of 0; one that touches it and moves inwards crosses the box first.
   Where rounding has put the disk a hair beyond, the same holds. A disk at
   rest never comes to the wall, wherever it is: INFINITY.

   Check your answer with    make check EX=05a
   Hints, which ask before they tell:    make hint EX=05a */

#include "exercise.h"
#include <math.h>

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2])
{
    /* TODO: replace these lines by your own. On which curve is the centre
       of the disk when the disk touches the wall, and how many times does
       a straight line cross that curve? */
    (void)box;
    (void)radius;
    (void)v;
    return NOT_DONE_YET(r[0]);
}
