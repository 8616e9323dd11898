/* mistake: none */
/* unnamed: touching-refused */
/* To touch is taken for an overlap, and to touch the wall for leaving. */

#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>

double uniform(void);

/* Says whether disk i might lie at (a, b) while the others stay. */
static bool allowed(size_t n, double radius, double dish, const double x[],
                    const double y[], size_t i, double a, double b)
{
    const double room = dish - radius, reach = 2.0 * radius;
    bool free = a * a + b * b < room * room;
    for (size_t k = 0; k < n && free; ++k) {
        const double dx = a - x[k], dy = b - y[k];
        free = k == i || dx * dx + dy * dy > reach * reach;
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
