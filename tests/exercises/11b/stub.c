/* Exercise 11b. What leaves the cradle? (core, 30 minutes)

   The balls of Newton's cradle stand in a row, with gaps between neighbours
   that are all equal, and tiny. Some of them fly in. Which velocities do
   they have when all is over?

   Two neighbours collide elastically when they meet. Collisions take place
   in the order of time, however short the gaps are: a ball may be hit from
   both sides in turn, and more than once. All is over when none is any
   faster than its neighbour on the right. Speeds that differ by less than
   1e-9 of the largest speed at the start are equal but for rounding: such
   two do not approach each other.

   Given:
     n        the number of balls, 100 at most; there may be none
     mass     mass[i] is that of ball i, in kg; ball 0 is on the left
     v        v[i] is its velocity at the start, in m/s, positive to the
              right; at that time all gaps are equal
   To change:
     v        the velocities at the end
   Returns the number of collisions.

   No ball is ever hit from both sides at the same time, unless the masses
   are such that the order does not matter.

   Check your answer with    make check EX=11b
   Hints, which ask before they tell:    make hint EX=11b */

#include "exercise.h"
#include <stddef.h>

size_t cradle(size_t n, const double mass[], double v[])
{
    /* TODO: replace these lines by your own. Which two meet first? Where
       are all the others then, and who meets next? */
    (void)n;
    (void)mass;
    v[0] = NOT_DONE_YET(0.0);
    return 0;
}
