/* A right answer in plain C, with which wrong.diff begins. */

#include <stdbool.h>

size_t pareto_front(size_t n, const struct choice c[], size_t f[])
{
    size_t i, j, k, m = 0;
    for (i = 0; i < n; i++) {
        bool ok = isfinite(c[i].error);
        for (j = 0; j < n; j++)
            if (c[j].cost <= c[i].cost && c[j].error <= c[i].error &&
                (c[j].cost != c[i].cost || c[j].error != c[i].error))
                ok = false;
        if (ok) {
            for (k = m++; k > 0 && c[f[k - 1]].cost > c[i].cost; k--)
                f[k] = f[k - 1];
            f[k] = i;
        }
    }
    return m;
}
