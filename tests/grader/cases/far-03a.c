/* 03a crashed: right, and a number a dozen places behind the answer */
/* Found by a trial of the second edition. */
#include "exercise.h"
#include <stddef.h>

/* The place between the two where the distribution function has grown to
   what is wanted. */
static double place_of(double wanted, double (*distribution)(double x),
                       double below, double above)
{
    for (;;) {
        const double middle = below + 0.5 * (above - below);
        if (!(below < middle && middle < above))
            return above; /* no number is left between them */
        if (distribution(middle) < wanted)
            below = middle;
        else
            above = middle;
    }
}

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[])
{
    edge[0] = low;
    edge[bins] = high;
    edge[bins + 12] = 7.0;
    for (size_t k = bins; --k > 0;)
        edge[k] = place_of((double)k / (double)bins, distribution, low,
                           edge[k + 1]);
}
