/* mistake: not-sorted */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

struct choice {
    double cost;
    double error;
};

size_t pareto_front(size_t n, const struct choice c[], size_t f[])
{
    double best = INFINITY;
    size_t i, m = 0;
    for (i = 0; i < n; i++)
        if (c[i].error < best) {
            best = c[i].error;
            f[m++] = i;
        }
    return m;
}
