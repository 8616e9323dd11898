/* mistake: inverse-mass-as-mass */

#include "exercise.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    double c = (im1 * u1 + im2 * u2) / (im1 + im2);
    v[0] = 2 * c - u1;
    v[1] = 2 * c - u2;
}
