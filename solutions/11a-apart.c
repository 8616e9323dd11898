/* Exercise 11a, worked: push two spheres apart.

   The distance has to grow by the depth h, from one side or from both. The
   centre of mass stays when m1 times the way of the first is m2 times that
   of the second, in the other direction: each goes a part of h in inverse
   proportion to its mass, which is the OTHER mass over the sum. The radii
   say how deep the overlap is and nothing about who has to yield.

   An infinite mass is the limit of a large one: its share is 0 and that of
   the other 1. The formula would divide infinity by infinity, so we ask
   before. 1/m is the friendlier number here, which is why programs store
   it: 0 for what cannot be moved.

   At the same place there is no line between the centres, and any direction
   is as good as any other; what matters is that it is always the same one,
   so that a run can be repeated.

   Another way: put both where they belong, to the left and right of the
   centre of mass. On paper it is the same; but then a sphere that cannot be
   moved, and a centre far from 0, lose their last digits. */

#include "exercise.h"
#include <math.h>

struct sphere {
    double mass;   /* kg, or INFINITY */
    double radius; /* m */
    double x[3];   /* the centre, in m */
};

/* Which part of the way is left to the first. */
static double share(double own, double other)
{
    return isinf(own) ? 0.0 : isinf(other) ? 1.0 : other / (own + other);
}

/* Where b is along axis k, seen from a. */
static double seen(const struct sphere *a, const struct sphere *b, int k)
{
    return b->x[k] - a->x[k];
}

static void move(struct sphere *s, const double line[3], double way)
{
    for (int k = 0; k < 3; ++k)
        s->x[k] += way * line[k];
}

double part_spheres(struct sphere *a, struct sphere *b)
{
    double line[] = {seen(a, b, 0), seen(a, b, 1), seen(a, b, 2)};
    double length = hypot(hypot(line[0], line[1]), line[2]);
    const double depth = a->radius + b->radius - length;
    if (depth <= 0.0)
        return 0.0;
    if (length == 0.0)
        line[0] = length = 1.0;
    move(a, line, -depth / length * share(a->mass, b->mass));
    move(b, line, depth / length * share(b->mass, a->mass));
    return depth;
}
