/* mistake: whole-number-division */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool bin_surprise(size_t count, size_t samples, double probability,
                  double inefficiency, double *z)
{
    double g = inefficiency < 1 ? 1 : inefficiency;
    double n = (double)samples / g;
    double share = (double)(count / samples);
    if (!(n * probability >= 5 && n * (1 - probability) >= 5))
        return false;
    *z = (share - probability) / sqrt(probability * (1 - probability) / n);
    return true;
}
