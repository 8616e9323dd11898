/* crashed: right in all, and one number more behind the answer */
/* earns: nothing */
#include "exercise.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    const double centre = (im2 * u1 + im1 * u2) / (im1 + im2);
    for (int i = 0; i <= 2; ++i)
        v[i] = 2.0 * centre - (i == 0 ? u1 : u2);
}
