/* A right answer: into the centre's frame, turn round, and back. */

#include "exercise.h"

static double centre(double u1, double u2, double im1, double im2)
{
    if (im1 == 0)
        return u1;
    return u1 + (u2 - u1) / (1 + im2 / im1);
}

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    double c = centre(u1, u2, im1, im2);
    double w[2];
    int i;
    w[0] = u1 - c;
    w[1] = u2 - c;
    for (i = 0; i < 2; i++)
        v[i] = c - w[i];
}
