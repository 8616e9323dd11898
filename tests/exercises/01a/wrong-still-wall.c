/* mistake: wall-at-rest */

#include "exercise.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    double m1, m2, c;
    v[0] = im1 == 0 ? 0 : -u1;
    v[1] = im2 == 0 ? 0 : -u2;
    if (im1 == 0 || im2 == 0)
        return;
    m1 = 1 / im1;
    m2 = 1 / im2;
    c = (m1 * u1 + m2 * u2) / (m1 + m2);
    v[0] = 2 * c - u1;
    v[1] = 2 * c - u2;
}
