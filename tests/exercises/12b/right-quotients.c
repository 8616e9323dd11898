/* Without logarithms: what should the quotient of the errors be? */

#include "exercise.h"
#include <math.h>

enum verdict { OUT_OF_REACH, TOO_FINE, NO_ORDER, CHOSEN };

static int small(double x, double rounding)
{
    return x <= 10 * rounding && -x <= 10 * rounding;
}

enum verdict choose_step(double p, const double h[2], const double error[2],
                         double rounding, double tolerance, double *step)
{
    const double steps = h[0] / h[1], errors = fabs(error[0] / error[1]);
    *step = NAN;
    if (small(tolerance, rounding))
        return OUT_OF_REACH;
    if (small(error[0], rounding) || small(error[1], rounding))
        return TOO_FINE;
    if (pow(steps, p - 0.3) < errors && errors < pow(steps, p + 0.3)) {
        *step = h[1] / pow(fabs(error[1]) / tolerance, 1 / p) / 1.2;
        if (*step > h[0])
            *step = h[0];
        return CHOSEN;
    }
    return NO_ORDER;
}
