/* mistake: g-not-rooted */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool bin_surprise(size_t count, size_t samples, double probability,
                  double inefficiency, double *z)
{
    double n = (double)samples, k = (double)count, p = probability;
    double g = fmax(1, inefficiency);
    if (!(n / g * p >= 5 && n / g * (1 - p) >= 5))
        return false;
    *z = (k - n * p) / sqrt(n * p * (1 - p)) / g;
    return true;
}
