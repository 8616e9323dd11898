/* Exercise 05b, worked: two disks that fall.

   Whoever falls along with disk a sees no gravity: in the difference of
   b.y + b.vy t - g t^2/2 and a.y + a.vy t - g t^2/2 the last terms cancel.
   So b moves past on a straight line, and the two touch when the distance
   of their centres is the sum of their radii, as in the book.

   Here `shrinks` is minus the product of distance and relative velocity,
   which is positive when they approach. That alone decides whether
   there is anything to find. They meet at the smaller root of the
   quadratic. Its usual form, (shrinks - root) / speed^2, takes the
   difference of two numbers that are nearly equal when the gap is small; a
   gap of 1e-8 of the distance loses half of all digits. Multiplied above
   and below by shrinks + root it becomes gap / (shrinks + root), a sum,
   where gap is the distance squared less the contact distance squared. It
   needs no division by the velocity, and where the disks touch it is 0.
   A gap that is negative by rounding counts as none.

   For the height gravity is back: both centres have fallen by g t^2/2. The
   point of contact divides the line of the centres as the radii do, and it
   is nearer to the centre of the smaller one.

   Another way: turn the picture so that the relative velocity is along one
   axis. The path passes the centre of a at a distance that does not change,
   and the disks touch half a chord before it is nearest. */

#include "exercise.h"
#include <math.h>

struct thrown {
    double x, y;   /* of the centre, in m: across and up */
    double vx, vy; /* its velocity, in m/s */
    double radius; /* m */
};

static double contact_time(const struct thrown *a, const struct thrown *b)
{
    const double x = b->x - a->x, y = b->y - a->y;
    const double u = b->vx - a->vx, w = b->vy - a->vy;
    const double reach = a->radius + b->radius;
    const double gap = x * x + y * y - reach * reach;
    const double shrinks = -(x * u + y * w);
    const double under = shrinks * shrinks - (u * u + w * w) * gap;
    if (!(shrinks > 0.0 && under >= 0.0))
        return INFINITY;
    return fmax(0.0, gap) / (shrinks + sqrt(under));
}

double falling_pair_time(double g, const struct thrown *a,
                         const struct thrown *b, double *height)
{
    const double t = contact_time(a, b);
    const double part = a->radius / (a->radius + b->radius);
    const double y = a->y + part * (b->y - a->y);
    const double vy = a->vy + part * (b->vy - a->vy);
    *height = y + (vy - 0.5 * g * t) * t;
    return t;
}
