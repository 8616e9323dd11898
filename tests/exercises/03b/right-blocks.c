/* A right answer: as if only every g-th sample had been written down. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool bin_surprise(size_t count, size_t samples, double probability,
                  double inefficiency, double *z)
{
    double g = inefficiency > 1 ? inefficiency : 1;
    double kept = (double)samples / g;
    double kept_in = (double)count / g;
    double sigma = sqrt(kept * probability * (1 - probability));
    if (!(sigma > 0))
        return false;
    *z = kept_in / sigma - kept * probability / sigma;
    return kept * probability >= 5 && kept * (1 - probability) >= 5;
}
