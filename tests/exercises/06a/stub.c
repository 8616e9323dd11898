/* Exercise 06a. A sampler that keeps what fitted (core, 20 minutes)

   Disks are thrown into a box by chance. Every allowed placing, in which
   no disk reaches out of the box and no two overlap, was to be equally
   likely. The sampler below does not do that: all its placings are allowed,
   but some come too often. Mend it.

   Given:
     n        the number of disks, from 1 to 100
     radius   their radii, in m; they need not be equal
     width    of the box, in m, which reaches from (0, 0) ...
     height   ... to (width, height). There is room for all the disks.
   To fill in:
     x, y     the centres of the disks, in m
   Returns how often all disks were thrown, the last time included: 1 when
   the first throw fitted.

   All that is random comes from uniform(), which the check provides: a
   number from 0 to below 1. A placing is made of the last 2 n numbers that
   were asked for: x and y of disk 0, x and y of disk 1, and so on. It is up
   to you whether a throw ends at its first overlap or is finished all the
   same.

   Check your answer with    make check EX=06a
   Hints, which ask before they tell:    make hint EX=06a */

#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>

double uniform(void);

/* A coordinate somewhere along a side of the box, a radius off its ends. */
static double along(double size, double radius)
{
    return radius + (size - 2.0 * radius) * uniform();
}

/* Says whether disk i overlaps none of those before it. */
static bool fits(size_t i, const double radius[], const double x[],
                 const double y[])
{
    for (size_t j = i; j-- > 0;) {
        const double dx = x[i] - x[j], dy = y[i] - y[j];
        const double reach = radius[i] + radius[j];
        if (dx * dx + dy * dy < reach * reach)
            return false;
    }
    return true;
}

size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[])
{
    /* TODO: mend these lines. No two disks overlap when they are done; but
       how did the first ones come by their places? */
    size_t throws = NOT_DONE_YET(1);
    for (size_t i = 0; i < n; ++i)
        do {
            x[i] = along(width, radius[i]);
            y[i] = along(height, radius[i]);
        } while (!fits(i, radius, x, y));
    return throws;
}
