/* mistake: nothing-divided */
/* The force as the difference of the shares of both gases: 0/0 without gas.
 */

#include "exercise.h"
#include <math.h>

static double push(int f, double middle, double energy, double l)
{
    return 2.0 / f * energy * pow(middle / l, 2.0 / f) / l;
}

void piston_slopes(int f, double length, double mass, double gas,
                   const double energy[2], const double state[2],
                   double slope[2])
{
    double left = push(f, length / 2, energy[0], state[0]);
    double right = push(f, length / 2, energy[1], length - state[0]);
    double all = left + right;
    slope[0] = state[1];
    slope[1] = (left / all - right / all) * all / (mass + gas / 3);
}
