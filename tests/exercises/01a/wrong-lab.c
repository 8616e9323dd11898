/* mistake: reversed-in-the-lab */

#include "exercise.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    (void)im1;
    (void)im2;
    v[0] = -u1;
    v[1] = -u2;
}
