/* Exercise 12b, worked: a step from two errors.

   If the error is C h^p, then to make it smaller by some factor the step
   must become smaller by the p-th root of it: for the fourth order a tenth
   of the error costs only 1.78 times as many steps, and that is what an
   order is good for. C need not be known. It goes through the smaller step
   since there the terms of higher order are smaller.

   The second error is there for doubt. With it the order is measured, and a
   wrong one tells that the steps are too large still, or that some other
   error is in the way, such as that of the reference; then C h^p would be a
   guess. Only its sign and its size at two places are known, so it is taken
   for a check, and not for p: an exponent of 1.7 in place of 2 would make
   quite another step for a tolerance that is far away.

   The comparison is written so that not-a-number fails it: !(a <= b) is
   true where a > b would be false. An infinity makes the quotient infinite
   or zero, its logarithm infinite, and fails too.

   A run can be too fine as well. An error that is mostly rounding may have
   any size, nothing included, and its logarithm would say anything. And if
   the tolerance itself is down there, a smaller step makes it worse, since
   there is more to round.

   Another way: without logarithms, by asking whether the errors' quotient
   lies between (h0/h1)^(p-0.3) and (h0/h1)^(p+0.3). */

#include "exercise.h"
#include <math.h>

enum verdict { OUT_OF_REACH, TOO_FINE, NO_ORDER, CHOSEN };

enum verdict choose_step(double p, const double h[2], const double error[2],
                         double rounding, double tolerance, double *step)
{
    const double coarse = fabs(error[0]), fine = fabs(error[1]);
    const double least = 10.0 * rounding;
    const double shown = log(coarse / fine) / log(h[0] / h[1]);
    *step = NAN;
    if (tolerance <= least)
        return OUT_OF_REACH;
    if (coarse <= least || fine <= least)
        return TOO_FINE;
    if (!(fabs(shown - p) <= 0.3))
        return NO_ORDER;
    const double enough = h[1] * pow(tolerance / fine, 1.0 / p);
    *step = fmin(enough / 1.2, h[0]);
    return CHOSEN;
}
