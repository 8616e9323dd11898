/* mistake: only-the-neighbour */

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
    size_t i, k, m = 0, left = 0;
    for (i = 0; i < n; i++)
        if (isfinite(c[i].error)) {
            for (k = m++; k > 0 && (c[f[k - 1]].cost > c[i].cost ||
                                    (c[f[k - 1]].cost == c[i].cost &&
                                     c[f[k - 1]].error > c[i].error));
                 k--)
                f[k] = f[k - 1];
            f[k] = i;
        }
    for (i = m; i-- > 1;)
        if (c[f[i]].error > c[f[i - 1]].error)
            f[i] = n;
    for (i = 0; i < m; i++)
        if (f[i] < n)
            f[left++] = f[i];
    return left;
}
