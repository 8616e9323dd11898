/* A straight line on paper with logarithmic axes. */

#include "exercise.h"
#include <math.h>
#include <stdlib.h>

enum verdict { OUT_OF_REACH, TOO_FINE, NO_ORDER, CHOSEN };

enum verdict choose_step(double p, const double h[2], const double error[2],
                         double rounding, double tolerance, double *step)
{
    double x[2], y[2], up, slope, where;
    int i;
    *step = NAN;
    if (!(tolerance > 10 * rounding))
        return OUT_OF_REACH;
    for (i = 0; i < 2; i++) {
        x[i] = log10(h[i]);
        y[i] = log10(fabs(error[i]));
        if (fabs(error[i]) <= 10 * rounding)
            return TOO_FINE;
    }
    slope = (y[1] - y[0]) / (x[1] - x[0]);
    if (!isfinite(slope) || slope < p - 0.3 || slope > p + 0.3)
        return NO_ORDER;
    up = log10(tolerance) - y[1];
    where = x[1] + up / p - log10(1.2);
    *step = where < x[0] ? pow(10, where) : h[0];
    return CHOSEN;
}
