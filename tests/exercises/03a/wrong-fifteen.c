/* mistake: stops-early */
/* A tolerance of 1e-15, wherever the edge is. */

#include "exercise.h"
#include <stddef.h>

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[])
{
    edge[0] = low;
    edge[bins] = high;
    for (size_t k = 1; k < bins; k++) {
        double a = low, b = high, c = (a + b) / 2;
        for (; b - a > 1e-15 && a < c && c < b; c = (a + b) / 2)
            if (distribution(c) < (double)k / (double)bins)
                a = c;
            else
                b = c;
        edge[k] = c;
    }
}
