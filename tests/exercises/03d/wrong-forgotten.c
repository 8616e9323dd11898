/* mistake: blocks-forgotten */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

static double average(size_t n, const double x[])
{
    double sum = 0;
    size_t i;
    for (i = 0; i < n; i++)
        sum += x[i] - x[0];
    return x[0] + sum / (double)n;
}

static double variance(size_t n, const double x[])
{
    double m = average(n, x), sum = 0;
    size_t i;
    for (i = 0; i < n; i++)
        sum += (x[i] - m) * (x[i] - m);
    return sum / ((double)n - 1);
}

bool error_by_blocks(size_t n, const double x[], size_t length,
                     double *error, double *inefficiency)
{
    size_t blocks, i, used;
    double b, m, v = 0, naive;
    if (length == 0 || n / length < 2)
        return false;
    blocks = n / length;
    used = blocks * length;
    b = (double)blocks;
    m = average(used, x);
    for (i = 0; i < blocks; i++) {
        double d = average(length, x + i * length) - m;
        v += d * d / (b - 1);
    }
    naive = variance(used, x) / (double)used;
    (void)v;
    *error = sqrt(naive);
    *inefficiency = v / b / naive;
    return true;
}
