/* mistake: outside-forgotten */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool bin_surprise(size_t count, size_t samples, double probability,
                  double inefficiency, double *z)
{
    double n = (double)samples, p = probability;
    double g = inefficiency < 1 ? 1 : inefficiency;
    if (!(p < 1 && n * p / g >= 5))
        return false;
    *z = ((double)count - n * p) / sqrt(n * p * (1 - p) * g);
    return true;
}
