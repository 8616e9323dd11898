/* mistake: stops-early */
/* Sixty halvings, wherever the edge is. Found by a trial of the second
 * edition, when it earned full points. */

#include "exercise.h"
#include <stddef.h>

/* The place between the two where the distribution function has grown to
   what is wanted. */
static double place_of(double wanted, double (*distribution)(double x),
                       double below, double above)
{
    for (int it = 0;; ++it) {
        const double middle = below + 0.5 * (above - below);
        if (!(below < middle && middle < above) || it == 60)
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
    for (size_t k = bins; --k > 0;)
        edge[k] = place_of((double)k / (double)bins, distribution, low,
                           edge[k + 1]);
}
