/* mistake: sign-of-the-difference */

#include "exercise.h"
#include <math.h>

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    double d = fabs(u1 - u2);
    v[0] = u1 - 2 * im1 / (im1 + im2) * d;
    v[1] = u2 + 2 * im2 / (im1 + im2) * d;
}
