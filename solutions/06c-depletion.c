/* Exercise 06c, worked: pushed together by nothing.

   Around each big body there is a zone of the radius Z = R + small. Two
   zones meet when r is less than Z1 + Z2. Their edges then cross in two
   points (in a circle, for spheres), each as far from centre 1 as Z1 and
   from centre 2 as Z2. Let the chord between them lie at the distance c1
   from centre 1, seen towards centre 2, and be 2 s long. Pythagoras says
       c1^2 + s^2 = Z1^2,    (r - c1)^2 + s^2 = Z2^2,
   and the difference of the two has only one unknown left:
       c1 = (r^2 + Z1^2 - Z2^2) / (2 r),    c2 = r - c1.
   For equal zones that is the middle.

   The chord cuts the shared lens into two pieces, one of each zone. In the
   plane a piece is a sector less a triangle, Z^2 acos(c/Z) - c s; in the
   room a cap of the height h = Z - c, pi h^2 (3 Z - h)/3. The chord may lie
   behind the centre of a zone that is much smaller. Then its c is negative,
   and both formulas remain right: the acos is more than a right angle, and
   the triangle is added.

   Small ones that do not feel each other are an ideal gas. Room is worth
   its pressure, kT times the density, to them; they gain the overlap, and
   the potential is minus that. It is deepest where the big ones touch.

   What becomes of it when R2 is very large? A body at a flat wall, whose
   overlap is larger than that of two equal bodies: by the factor 2 in the
   room, by the root of 2 in the plane, if the small ones are very small.

   In C, the angle is taken as atan2(s, c): it is the acos(c/Z), and keeps
   its digits where the lens is thin and c/Z close to 1. The tests of r come
   first, in this order: two big ones that overlap are forbidden even where
   there are no small ones at all, and beyond Z1 + Z2 the formulas of the
   pieces mean nothing.

   Another way: the area that the zones share is the integral of the chord
   2 s over the distance, from r to Z1 + Z2: for the overlap grows by its
   chord when the two come closer. Its volume is that of pi s^2. */

#include "exercise.h"
#include <math.h>

/* What a chord at the distance c from its centre cuts off a zone. */
static double piece(int dimensions, double zone, double c)
{
    const double pi = 3.14159265358979323846;
    const double height = zone - c;
    const double s = sqrt(height * (zone + c));
    if (dimensions == 2)
        return zone * zone * atan2(s, c) - c * s;
    return pi / 3.0 * height * height * (2.0 * zone + c);
}

double depletion(int dimensions, double R1, double R2, double small,
                 double density, double r, double *overlap)
{
    const double zone1 = R1 + small, zone2 = R2 + small;
    *overlap = 0.0;
    if (r < R1 + R2)
        return INFINITY;
    if (r >= zone1 + zone2)
        return 0.0;
    const double c1 = 0.5 * (r + (zone1 - zone2) * (zone1 + zone2) / r);
    *overlap =
        piece(dimensions, zone1, c1) + piece(dimensions, zone2, r - c1);
    return -density * *overlap;
}
