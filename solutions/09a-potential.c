/* Exercise 09a, worked: the potential of the softened force.

   The derivative of (r^2 + e^2)^(-1/2) by r is -r (r^2 + e^2)^(-3/2): so
   -k2 m/sqrt(r^2 + e^2) is the potential whose gradient, turned round, is
   the force that was given, and it vanishes far away. The power is 1/2 and
   not 3/2, and the e belongs under the root: -k2 m/(r + e) is a potential
   too, but of another force. With the wrong one the energy seems to wander
   in every encounter that is close, and one blames the method.

   The potential at a body leaves out the body itself. Its own term would be
   -k2 m/e, a constant that no force notices, but one that becomes infinite
   without softening.

   A pair has one energy, -k2 m_i m_j/sqrt(r^2 + e^2). The sum over all i of
   m_i potential[i] counts each pair twice, once from either side; half of
   it is the energy. Going over pairs instead costs half as many roots, and
   each pair then gives a share to both of its bodies.

   A sum of n terms of the same sign loses n roundings at most, and nothing
   cancels. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

/* The root of the squares along all axes and of the softening. */
static double root_of(size_t n, const double one[], const double other[],
                      double softening)
{
    const double x = *one - *other, y = one[n] - other[n];
    const double z = one[n + n] - other[n + n];
    return sqrt(x * x + y * y + z * z + softening * softening);
}

double potential_energy(size_t n, const double mass[], const double x[],
                        double k2, double softening, double potential[])
{
    double energy = 0.0;
    for (size_t i = n; i-- > 0;) {
        potential[i] = 0.0;
        for (size_t j = n; --j > i;) {
            const double u = k2 / root_of(n, x + i, x + j, softening);
            potential[i] -= u * mass[j];
            potential[j] -= u * mass[i];
        }
        energy += mass[i] * potential[i];
    }
    return energy;
}
