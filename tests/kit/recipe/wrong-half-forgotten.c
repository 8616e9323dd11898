/* mistake: half-forgotten */

#include "exercise.h"

double energy_at_stake(double u1, double u2, double im1, double im2)
{
    return (u1 - u2) * (u1 - u2) / (im1 + im2);
}
