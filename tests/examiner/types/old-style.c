/* 01a passed: a definition in the old style, with the types that were given */
#include "exercise.h"

void velocities_after(u1, u2, im1, im2, v)
double u1, u2, im1, im2;
double v[2];
{
    const double centre = (im2 * u1 + im1 * u2) / (im1 + im2);
    v[0] = 2.0 * centre - u1;
    v[1] = 2.0 * centre - u2;
}
