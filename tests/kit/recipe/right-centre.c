/* 01f by way of the centre of mass: the two energies that are seen from
   there, whose momenta are equal. */

#include "exercise.h"

double energy_at_stake(double u1, double u2, double im1, double im2)
{
    const double p = (u1 - u2) / (im1 + im2);
    return 0.5 * p * p * im1 + 0.5 * p * p * im2;
}
