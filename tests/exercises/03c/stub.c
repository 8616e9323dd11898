/* Exercise 03c. The exact law of the velocities (core, 30 minutes)

   n movers share a fixed energy and nothing else is conserved. Measure a
   velocity in units of the largest that its body can have: u lies between
   -1 and 1 and has the density C_n (1 - u^2)^((n - 3)/2). A test of a run
   against this law wants its distribution function: how probable is a
   value below u?

   Given:
     n   the number of movers, 2 to 100
     u   the velocity in units of the largest, any number
   Returns the probability of a velocity below u, from 0 to 1; 0 where u is
   -1 or less and 1 where it is 1 or more. The error must be below 1e-13.

   There is no library here but <math.h>. A pencil finds what a law has to
   do with that of two movers fewer.

   Check your answer with    make check EX=03c
   Hints, which ask before they tell:    make hint EX=03c */

#include "exercise.h"
#include <math.h>

double velocity_below(int n, double u)
{
    /* TODO: replace these lines by your own. Which two of these laws have a
       formula that you know, and what does integrating by parts do to the
       exponent of the others? */
    (void)n;
    return NOT_DONE_YET(u);
}
