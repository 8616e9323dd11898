/* mistake: sorted-first */

#include "exercise.h"
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static int smaller(const void *a, const void *b)
{
    double x = fabs(*(const double *)a), y = fabs(*(const double *)b);
    return x < y ? -1 : x > y;
}

double sum_up(size_t n, const double part[])
{
    double *x = malloc((n + 1) * sizeof *x), s = 0;
    size_t i;
    if (n)
        memcpy(x, part, n * sizeof *x);
    qsort(x, n, sizeof *x, smaller);
    for (i = 0; i < n; i++)
        s += x[i];
    free(x);
    return s;
}
