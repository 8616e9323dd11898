/* Exercise 07a. How fast is a disk? (core, 25 minutes)

   n disks of equal mass collide with each other and with the walls of a box
   in the plane. Only their energy is conserved, so the mean of their
   squared speeds never changes. The fastest that one of them can ever be is
   when it has all the energy, and the others rest. The law of its speed,
   taken over a long time, is the book's law for finite n; Maxwell's and
   Boltzmann's is what it becomes when n grows. How probable is a speed
   below v, and what is the mean of the fourth power of the speed?

   Given:
     n            the number of disks, 1 to 1000000000
     mean_square  the mean over the disks of the squared speed, larger than
                  0, in m^2/s^2
     v            a speed in m/s, any number, INFINITY too
   To fill in:
     *fourth      the mean of the fourth power of a disk's speed over a long
                  time, in m^4/s^4, which does not depend on v
   Returns the probability of a speed below v, from 0 to 1: 0 where v is 0
   or less, and 1 where no disk can be so fast. One disk alone has always
   the same speed; nobody will ask for exactly that v.

   The relative error of both must be below 1e-12, for a v that is a
   millionth of the others as well, and for a thousand million disks.

   Check your answer with    make check EX=07a
   Hints, which ask before they tell:    make hint EX=07a */

#include "exercise.h"
#include <math.h>

double speed_below(int n, double mean_square, double v, double *fourth)
{
    /* TODO: replace these lines by your own. Which share of all the energy
       has a disk with the speed v? And what is left of 1 minus a very small
       share in a double? */
    (void)n;
    (void)mean_square;
    *fourth = 0.0;
    return NOT_DONE_YET(v);
}
