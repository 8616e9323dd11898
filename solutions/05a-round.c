/* Exercise 05a, worked: the time to a round wall.

   The disk touches the wall when its centre is on a circle of the radius
   s = box - radius. With the centre at r + v t that is
       v.v t^2 + 2 r.v t - (s^2 - r.r) = 0,
   a quadratic whose last term is the room that is left, not negative inside
   the circle. A straight line that comes from within leaves the circle
   once, at the larger root; the smaller one is where it would have come in,
   in the past. So the plus sign of the root is always right here, whereas
   two disks outside each other meet at the smaller root.

   The larger root has two forms, equal on paper. When the disk moves
   outwards, r.v > 0, the plus sign takes the difference of two numbers that
   are nearly equal near the wall, and the other form, room / (r.v + root),
   takes a sum. On the wall it says 0 as it should, and a room that rounding
   has made negative counts as none. When the disk moves inwards the first
   form is the sum: on the wall it gives the whole chord.

   There is one more trap: a hair beyond the wall and almost along it the
   root may be that of a negative number. The path then only just misses the
   circle, and the nearest thing to touching is a root of 0.

   Another way: split r into a part along the path and one across it. The
   path cuts the circle in a chord; half of it, less the part along, is the
   way to go. */

#include "exercise.h"
#include <math.h>

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2])
{
    const double reach = box - radius;
    const double x = r[0], y = r[1], u = v[0], w = v[1];
    const double room = reach * reach - (x * x + y * y);
    const double outward = x * u + y * w, speed_squared = u * u + w * w;
    if (speed_squared == 0.0)
        return INFINITY;
    const double root =
        sqrt(fmax(0.0, outward * outward + speed_squared * room));
    if (outward > 0.0)
        return fmax(0.0, room) / (outward + root);
    return (root - outward) / speed_squared;
}
