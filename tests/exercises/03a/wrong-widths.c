/* mistake: equal-widths */

#include "exercise.h"
#include <stddef.h>

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[])
{
    size_t k;
    (void)distribution;
    for (k = 0; k <= bins; k++)
        edge[k] = low + (high - low) * (double)k / (double)bins;
    edge[bins] = high;
}
