/* Exercise 01a. Two bodies meet (warm-up, 10 minutes)

   Two bodies on a line collide, and no energy is lost. Their velocities
   before are known; how fast does each move after?

   Given:
     u1, u2    the velocities before, in m/s, positive to the right
     im1, im2  the inverse masses 1/m, in 1/kg. An inverse mass of zero
               is a wall: so heavy that no blow changes its velocity.
               None is negative, and at most one of the two is zero.
   To fill in:
     v[0]      the velocity of the first body after, in m/s
     v[1]      the velocity of the second body after, in m/s

   Check your answer with    make check EX=01a
   Hints, which ask before they tell:    make hint EX=01a */

#include "exercise.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    /* TODO: replace these lines by your own. How does the velocity of the
       centre of mass look when it is written with inverse masses, so
       that a wall needs no special care? */
    (void)im1;
    (void)im2;
    v[0] = NOT_DONE_YET(u1);
    v[1] = NOT_DONE_YET(u2);
}
