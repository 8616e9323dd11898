/* A right answer: walls first, then the mass form of the textbooks. */

#include "exercise.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    double m1, m2;
    if (im1 == 0) {
        v[0] = u1;
        v[1] = u1 + u1 - u2;
        return;
    }
    if (im2 == 0) {
        v[1] = u2;
        v[0] = u2 + u2 - u1;
        return;
    }
    m1 = 1 / im1;
    m2 = 1 / im2;
    v[0] = ((m1 - m2) * u1 + 2 * m2 * u2) / (m1 + m2);
    v[1] = (2 * m1 * u1 + (m2 - m1) * u2) / (m1 + m2);
}
