/* Exercise 06a, worked: a sampler that keeps what fitted.

   Throw darts at the space of all placings: a point with 2 n coordinates.
   Each dart is equally likely to hit any point, and those that hit a
   forbidden one are taken away; what remains is evenly spread over the
   allowed ones. For that, every dart must be thrown anew, all of it. So an
   overlap of two disks is the end of the whole throw.

   What was wrong? The old sampler placed disk 0 as if it were alone. Its
   centre was spread evenly over the box, whatever the others did. But a
   disk in the middle leaves the others less room than one in a corner;
   fewer placings go with it. Throwing the last disk again and again until
   it fits hides that: it gives a tight beginning as much weight as a roomy
   one. And where the first disks leave no room at all, it never ends. (The
   old way has a use and a name of its own, random sequential adsorption:
   molecules that fall on a surface and stick. It is another distribution.)

   The price is that most throws are wasted. The share of those that are not
   is the acceptance, and for many disks in a small box it is hopelessly
   small.

   In C: one throw is a function that says whether all disks fitted, and
   the loop around it has nothing else to do. The throw may end at its first
   overlap, since what would still be thrown cannot mend it; that saves
   random numbers.

   Another way: one loop, which sets i back to 0 at an overlap. Or throw all
   n disks first and then look at every pair. */

#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>

double uniform(void);

/* A coordinate somewhere along a side of the box, a radius off its ends. */
static double along(double size, double radius)
{
    return radius + (size - 2.0 * radius) * uniform();
}

static double square(double a)
{
    return a * a;
}

/* Says whether disk i overlaps none of those before it. */
static bool fits(size_t i, const double radius[], const double x[],
                 const double y[])
{
    for (size_t j = i; j-- > 0;) {
        const double apart = square(x[i] - x[j]) + square(y[i] - y[j]);
        if (apart < square(radius[i] + radius[j]))
            return false;
    }
    return true;
}

/* Throws disk after disk; says whether all of them fitted. */
static bool thrown(size_t n, const double radius[], double width,
                   double height, double x[], double y[])
{
    bool good = true;
    for (size_t i = 0; i < n && good; ++i) {
        x[i] = along(width, radius[i]);
        y[i] = along(height, radius[i]);
        good = fits(i, radius, x, y);
    }
    return good;
}

size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[])
{
    size_t throws = 1;
    while (!thrown(n, radius, width, height, x, y))
        ++throws;
    return throws;
}
