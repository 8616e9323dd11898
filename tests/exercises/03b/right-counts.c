/* A right answer: in counts. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool bin_surprise(size_t count, size_t samples, double probability,
                  double inefficiency, double *z)
{
    double in, out, g;
    if (isnan(probability) || probability <= 0 || probability >= 1)
        return false;
    g = inefficiency;
    if (g < 1)
        g = 1;
    in = (double)samples * probability;
    out = (double)samples - in;
    if (in < 5 * g || out < 5 * g)
        return false;
    *z = ((double)count - in) / sqrt(in * out * g / (double)samples);
    return true;
}
