/* Exercise 01d, worked: taking aim.

   When the disks touch, their centres are r1 + r2 apart, and the line of
   centres makes an angle phi with the way of the first disk, where
   b = (r1 + r2) sin(phi). Seen from the centre of mass the blow turns the
   component along that line round and leaves the other alone, as a mirror
   does. So there the velocity is turned by chi = pi - 2 phi, and
   b = (r1 + r2) cos(chi / 2).

   Back in the laboratory the velocity of the centre of mass is added. The
   centre moves as fast as m1/m2 = im2/im1 times the first disk moves in the
   centre's frame. The two velocities and their sum make a triangle, with
   the angle deflection opposite the one side and chi - deflection opposite
   the other; the law of sines gives
       sin(chi - deflection) = im2 / im1 * sin(deflection).

   Two angles have this sine. The smaller chi is the weaker blow and has the
   larger b: asin() returns it. The other, pi minus that, belongs to the
   second impact parameter, which exists when the moving disk is the
   heavier. A sine above one says that no blow turns it so far: the limit is
   asin(m2/m1). And a moving disk that is not the lighter never turns back,
   though the sine of an obtuse angle looks harmless: this needs a test of
   its own.

   Another way: in components along and across the first way, the tangent of
   phi is the root of a quadratic equation, and b comes out with two square
   roots and no asin. Or write the forward collision and let bisection aim;
   it must be told on which side of the largest deflection to search. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection)
{
    const double sine = im2 / im1 * sin(deflection);
    const bool turns_back = cos(deflection) < 0.0;
    if (sine > 1.0 || (turns_back && im2 >= im1))
        return -1.0;
    const double chi = deflection + asin(sine);
    return (r1 + r2) * cos(0.5 * chi);
}
