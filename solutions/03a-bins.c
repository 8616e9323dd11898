/* Exercise 03a, worked: bins of equal probability.

   Edge k is the place where the distribution function has grown to
   k / bins. No formula for its inverse is needed. The function never
   falls, so one question in the middle of an interval tells in which half
   the place lies, and after some sixty questions the interval is as short
   as neighbouring numbers are. We ask until the middle is no longer
   between the two ends: then no number of the type double is left there,
   wherever on the axis that is, and no tolerance had to be chosen.

   The two ends are known and are not searched for. Where the law is flat
   near low, every place of the flat piece has the probability 0 below it,
   and a search would end at any of them.

   Each search can begin at the edge before, since the edges rise; this
   saves little, for each halving is worth only one bit, but it keeps the
   edges in order even when rounding makes the function waver.

   Another way: Newton's method asks less often, but needs the density, and
   where the law is flat or steep it is thrown out of the interval. Or turn
   the law's formula round, where it has one: the arcsine law of two movers
   has its edges at -cos(pi k / bins). */

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
    for (size_t k = bins; --k > 0;)
        edge[k] = place_of((double)k / (double)bins, distribution, low,
                           edge[k + 1]);
}
