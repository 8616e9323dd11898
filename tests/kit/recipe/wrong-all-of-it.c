/* mistake: all-of-it */

#include "exercise.h"

double energy_at_stake(double u1, double u2, double im1, double im2)
{
    return 0.5 * (u1 * u1 / im1 + u2 * u2 / im2);
}
