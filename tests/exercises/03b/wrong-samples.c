/* mistake: all-samples-counted */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool bin_surprise(size_t count, size_t samples, double probability,
                  double inefficiency, double *z)
{
    double n = (double)samples, p = probability;
    double g = inefficiency < 1 ? 1 : inefficiency;
    if (!(n * p >= 5 && n * (1 - p) >= 5))
        return false;
    *z = ((double)count - n * p) / sqrt(n * p * (1 - p) * g);
    return true;
}
