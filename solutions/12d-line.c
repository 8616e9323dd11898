/* Exercise 12d, worked: is this scene one-dimensional?

   A line is a point and a direction. The point is easy: the first body. Now
   the ways from there to all the others, all velocities, and the weight
   must point along one direction, so each two of these vectors must be
   parallel. It is enough to hold every one of them against one, the first
   that is not zero. Not against the one before it: nothing is parallel to
   everything, and so a body at rest would part those before it from those
   behind it.

   Two vectors are parallel when their cross product is zero. With whole
   numbers that can be asked exactly, and without a difference: of a b and
   c d one wants to know only whether they are equal. The numbers here have
   up to 31 bits and a sign, the products 62, which an int does not hold and
   neither does the significand of a double; a long long does. Quotients,
   the slopes, are rounded, and two that differ by less than 1e-16 would be
   the same.

   Whether the directions are those of the axes is never asked. A program
   that knows only "does anything have a y?" sends a cradle that hangs in a
   corner of the room into space, and gets the same result for much more
   money.

   In the scenes of the book the numbers are doubles, and a cradle at 30
   degrees is on its line only but for rounding. Then there is no exact
   answer, and one has to bound what the error does: exercise 12c.

   Another way: divide each vector by the largest number that divides its
   three components. Then there are only two that are parallel: they are the
   same, or opposite. */

#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>

struct body {
    int x[3]; /* its place, in nm */
    int v[3]; /* its velocity, in nm/s */
};

/* Whether the way from one place to another is along the line. The first
   way that is one tells where the line goes. */
static bool fits(const int from[3], const int to[3], int along[3])
{
    const bool unknown = !along[0] && !along[1] && !along[2];
    for (int k = 0; k < 3 && unknown; ++k)
        along[k] = to[k] - from[k];
    for (int k = 0; k < 3; ++k) {
        const int j = (k + 1) % 3;
        const long long one = along[k], other = along[j];
        if (one * (to[j] - from[j]) != other * (to[k] - from[k]))
            return false;
    }
    return true;
}

bool one_line(size_t n, const struct body body[], const int weight[3],
              int along[3])
{
    static const int rest[3] = {0, 0, 0};
    along[0] = along[1] = along[2] = 0;
    bool line = fits(rest, weight, along);
    for (const struct body *b = body; b < body + n && line; ++b)
        line = fits(body->x, b->x, along) && fits(rest, b->v, along);
    return line;
}
