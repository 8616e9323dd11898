/* mistake: mass-of-a-wall */

#include "exercise.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    double m1 = 1 / im1;
    double m2 = 1 / im2;
    double c = (m1 * u1 + m2 * u2) / (m1 + m2);
    v[0] = 2 * c - u1;
    v[1] = 2 * c - u2;
}
