/* 01a crashed: right, and a number a dozen places behind the answer */
/* Found by a trial of the second edition. */
#include "exercise.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    const double centre = (im2 * u1 + im1 * u2) / (im1 + im2);
    v[0] = 2.0 * centre - u1;
    v[1] = 2.0 * centre - u2;
    v[13] = 7.0;
}
