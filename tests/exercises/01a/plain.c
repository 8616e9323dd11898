/* A right answer in plain C, with which wrong.diff begins. */

#include "exercise.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    double c = (im2 * u1 + im1 * u2) / (im1 + im2);
    v[0] = 2 * c - u1;
    v[1] = 2 * c - u2;
}
