/* Exercise 01f. What a collision can cost at most (warm-up, 10 minutes)

   Two bodies move on a line with velocities u1 and u2 (m/s); their inverse
   masses are im1 and im2 (1/kg), and at most one of them is a wall, with
   inverse mass 0. Return the largest energy (J) that a collision of theirs
   can turn into heat: what is lost when they stick together.

   Check your answer with    make check EX=01f
   Hints, which ask before they tell:    make hint EX=01f */

#include "exercise.h"

double energy_at_stake(double u1, double u2, double im1, double im2)
{
    (void)u1, (void)u2, (void)im1, (void)im2;
    /* TODO: replace this line. */
    return NOT_DONE_YET(0.0);
}
