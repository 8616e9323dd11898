/* Exercise 01f, solved: only the relative motion can be lost, and its mass
   is the reduced one, 1 / (im1 + im2). */

#include "exercise.h"

double energy_at_stake(double u1, double u2, double im1, double im2)
{
    const double approach = u1 - u2;
    return 0.5 * approach * approach / (im1 + im2);
}
