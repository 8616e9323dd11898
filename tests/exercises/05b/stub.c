/* Exercise 05b. Two disks that fall (core, 25 minutes)

   Two disks of different size have been thrown, and both fall freely with
   the same acceleration: upright in a plane, with no floor and no walls.
   When do they touch, and at which height is the point where they do?

   Given:
     g        the acceleration, in m/s^2, downwards, not negative
     a, b     the disks, as they are now. They are apart, or they touch;
              only rounding may have let them overlap.
   To fill in:
     *height  the height of the point where the two touch, at the time when
              they do, in m. Not asked for when they never touch.
   Returns the time until then, in s, never less than 0, or INFINITY when
   they never touch. Two disks that touch or overlap meet now, after 0 s, if
   they approach; if they do not, that contact is none. (Which of the two
   is true of disks that pass and only just touch does not matter here.)
   However small a gap is, the formula must not lose digits that the numbers
   have: where all squares come out exactly, as they do for positions with
   few binary digits, the time must be good to 13 digits.

   Check your answer with    make check EX=05b
   Hints, which ask before they tell:    make hint EX=05b */

#include "exercise.h"
#include <math.h>

struct thrown {
    double x, y;   /* of the centre, in m: across and up */
    double vx, vy; /* its velocity, in m/s */
    double radius; /* m */
};

double falling_pair_time(double g, const struct thrown *a,
                         const struct thrown *b, double *height)
{
    /* TODO: replace these lines by your own. Somebody falls along with
       disk a: what does he see disk b do? */
    (void)a;
    (void)b;
    *height = NOT_DONE_YET(0.0);
    return g;
}
