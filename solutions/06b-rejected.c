/* Exercise 06b, worked: a chain that forgets its rejections.

   The chain has a clock, and its ticks are the tries. A try that is
   rejected is a tick like any other: the chain spends it in the placing
   where it is, and this placing counts once more. So the sum is taken after
   every try, whatever came of it, and divided by the number of tries.

   Why? In balance as many tries lead from a placing A to a placing B as
   from B to A, and both ways are proposed equally often: so A and B must be
   visited equally often. A placing in a corner, with few ways out, is also
   rarely reached; it makes up for that by staying. Whoever counts arrivals
   only, and not the stay, gives each placing a weight in proportion to its
   number of ways out. Disks at the wall and disks that touch have few. So
   they were counted too rarely, and the dish looked emptier at its rim than
   it is.

   For one disk one can say how much. In the middle of a large dish every
   move is accepted; at its wall, if the step is small, one half. So the
   wrong chain sees at the wall one half of the disks that are there.

   In C, the sum leaves the if, and the divisor is the number of tries. For
   a chain that cannot move at all, *accepted is 0 and would have made
   the average 0/0.

   Another way: count for how many tries each placing lasts, and weigh it
   with that when it ends. Or keep the sum of squares of the present placing
   and change it only by what the one disk that moved has changed. */

#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>

double uniform(void);

/* Says whether disk i might lie at (a, b) while the others stay. */
static bool allowed(size_t n, double radius, double dish, const double x[],
                    const double y[], size_t i, double a, double b)
{
    const double room = dish - radius, reach = 2.0 * radius;
    bool free = a * a + b * b <= room * room;
    for (size_t k = 0; k < n && free; ++k) {
        const double dx = a - x[k], dy = b - y[k];
        free = k == i || dx * dx + dy * dy >= reach * reach;
    }
    return free;
}

/* The sum of x^2 + y^2 over all disks. */
static double squares(size_t n, const double x[], const double y[])
{
    double sum = 0.0;
    for (size_t k = n; k-- > 0;)
        sum += x[k] * x[k] + y[k] * y[k];
    return sum;
}

double mean_square(size_t n, double radius, double dish, double step,
                   size_t tries, double x[], double y[], size_t *accepted)
{
    double sum = 0.0;
    *accepted = 0;
    for (size_t t = 1; t <= tries; ++t) {
        const size_t i = (size_t)((double)n * uniform());
        const double a = x[i] + step * (2.0 * uniform() - 1.0);
        const double b = y[i] + step * (2.0 * uniform() - 1.0);
        if (allowed(n, radius, dish, x, y, i, a, b)) {
            x[i] = a;
            y[i] = b;
            ++*accepted;
        }
        sum += squares(n, x, y);
    }
    return sum / ((double)n * (double)tries);
}
