/* mistake: margin-the-wrong-way */

#include "exercise.h"
#include <math.h>

enum verdict { OUT_OF_REACH, TOO_FINE, NO_ORDER, CHOSEN };

enum verdict choose_step(double p, const double h[2], const double error[2],
                         double rounding, double tolerance, double *step)
{
    double a = fabs(error[0]), b = fabs(error[1]), q, least = 10 * rounding;
    *step = NAN;
    if (tolerance <= least)
        return OUT_OF_REACH;
    if (a <= least || b <= least)
        return TOO_FINE;
    q = log(a / b) / log(h[0] / h[1]);
    if (!(fabs(q - p) <= 0.3))
        return NO_ORDER;
    *step = fmin(h[1] * pow(tolerance / b, 1 / p) * 1.2, h[0]);
    return CHOSEN;
}
