/* Shown in "The examiner" (Works): it counts from one. */
#include "exercise.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    v[1] = (im2 * u1 + im1 * (2 * u2 - u1)) / (im1 + im2);
    v[2] = (im1 * u2 + im2 * (2 * u1 - u2)) / (im1 + im2);
}
