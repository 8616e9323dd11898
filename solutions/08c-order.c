/* Exercise 08c, worked: measure an order.

   On paper with two logarithmic axes C h^p is a straight line of slope p,
   and so p is the difference of the logarithms of the errors over that of
   the logarithms of the steps. C cancels, and so do the units; the sign of
   an error does not matter, and must be gone before the logarithm. Nobody
   says that a step is half of the one before it.

   Which runs? Large steps show terms of higher order, C h^p (1 + D h +
   ...), so the smallest ones are the best, until their errors are mostly
   rounding: then the line bends, and may rise again, and any p can come
   out. A factor of 1000 leaves the error three digits. A run that blew up
   says that its step is beyond the limit of stability and nothing else.

   And how would we know? One pair always has a slope. If the pair before it
   has another one, at least one of the two is no order. So three runs are
   better than two. Two pairs that agree are no proof: the error may pass
   through zero, or some other error, of the reference perhaps, may be what
   does not go away; a constant error has p = 0 and is caught by the 0.5.

   In C: walk from the smallest step to the largest, and pass over what is
   of no use; !(|error| > limit) is true for not-a-number as well. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

enum verdict { TOO_FEW, NOT_YET, MEASURED };

static double slope_between(size_t i, size_t j, const double h[],
                            const double error[])
{
    return log(fabs(error[i] / error[j])) / log(h[i] / h[j]);
}

enum verdict measure_order(size_t n, const double h[], const double error[],
                           double rounding, double *order)
{
    size_t useful[3], count = 0;
    for (size_t i = n; i-- > 0 && count < 3;)
        if (isfinite(error[i]) && fabs(error[i]) > 1000.0 * rounding)
            useful[count++] = i;
    *order = NAN;
    if (count < 2)
        return TOO_FEW;
    *order = slope_between(useful[1], useful[0], h, error);
    if (*order < 0.5)
        return NOT_YET;
    if (count < 3)
        return MEASURED;
    const double before = slope_between(useful[2], useful[1], h, error);
    return fabs(before - *order) > 0.2 ? NOT_YET : MEASURED;
}
