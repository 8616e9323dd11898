/* Exercise 09b, worked: speeds for a circle.

   Two bodies: the distance goes round with omega^2 d^3 = k2 (m1 + m2), as
   if one of them stood still and had the mass of both. Each has its own
   circle around the centre of mass, and the lever's rule says how large
   they are: d m2/(m1 + m2) for the first, which is small when the first is
   heavy. So the relative speed sqrt(k2 (m1 + m2)/d) is shared out by the
   mass of the OTHER body. The momenta are then equal and opposite. The sum
   of the masses is what Kepler did not know: for the Earth it matters in
   the sixth digit.

   Who computes the small speed as the difference of the relative one and
   the large one loses as many digits as the masses differ by powers of ten;
   the product loses none.

   A choreography: body j is seen under the angle a = 2 pi j/n from the
   centre, over the chord 2 R sin(a/2). Its pull makes the angle 90 degrees
   minus a/2 with the way to the centre, so that only sin(a/2) of it points
   inwards:
       k2 m/(4 R^2 sin^2(a/2)) sin(a/2) = k2 m/(4 R^2 sin(pi j/n)).
   What pulls forwards is pulled backwards by the body opposite to it. The
   sum over all others is v^2/R. For n = 2 that is a binary of equal masses
   at the distance 2 R.

   The bodies j and n - j pull alike, and pairing them saves half of the
   sines; near j = n the sine is that of a number near pi, which has lost
   its digits relative to what is left: sin(pi (n-1)/n) is right to an
   epsilon of 1 only. For n = 1000 that costs three digits of one of the
   largest terms, and the pairing costs nothing. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

void binary_speeds(double k2, double m1, double m2, double d, double *v1,
                   double *v2)
{
    const double both = m1 + m2, relative = sqrt(k2 * both / d);
    *v1 = relative * (m2 / both);
    *v2 = relative * (m1 / both);
}

double choreography_speed(double k2, size_t n, double mass, double radius)
{
    const double step = acos(-1.0) / (double)n;
    double sum = 0.0;
    for (size_t j = 1; 2 * j <= n; ++j)
        sum += (2 * j == n ? 1.0 : 2.0) / sin(step * (double)j);
    return sqrt(0.25 * k2 * mass / radius * sum);
}
