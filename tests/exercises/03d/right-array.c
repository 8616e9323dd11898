/* A right answer: an array of block means, and one function called twice.
 */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>

static double average(const double *first, const double *end)
{
    double sum = 0, from = *first, many = (double)(end - first);
    while (first < end)
        sum += *first++ - from;
    return from + sum / many;
}

static double squared_error(const double *first, const double *end)
{
    double centre = average(first, end), many = (double)(end - first);
    double sum = 0;
    for (; first < end; first++)
        sum += (*first - centre) * (*first - centre);
    return sum / (many - 1) / many;
}

bool error_by_blocks(size_t n, const double x[], size_t length,
                     double *error, double *inefficiency)
{
    double *means, e2;
    size_t full = 0;
    if (length == 0 || length > n / 2)
        return false;
    means = malloc(n / length * sizeof *means);
    if (!means)
        return false;
    while ((full + 1) * length <= n) {
        means[full] = average(x + full * length, x + (full + 1) * length);
        full++;
    }
    e2 = squared_error(means, means + full);
    *error = sqrt(e2);
    *inefficiency = e2 / squared_error(x, x + full * length);
    free(means);
    return true;
}
