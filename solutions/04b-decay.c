/* Exercise 04b, worked: a decay time from noisy shares.

   The logarithm of y = A exp(-t / tau) is a straight line in t with the
   slope -1/tau. A small error e of y becomes the error e/y of ln y. So the
   logarithm is worst where y is small, and a point counts with the weight
   (y/e)^2. Without the weights the last points, which are nearly all noise,
   would turn the line as they like.

   Let the mean of the times, and that of the logarithms, be weighted means.
   The best line goes through that point, and its slope is
       b = sum w (t - <t>) (ln y - <ln y>) / sum w (t - <t>)^2.
   This is a sum of the logarithms, each times a number; with the variance
   1/w of each its variance becomes 1 / sum w (t - <t>)^2. Since
   tau = -1/b, a small change of b changes tau by tau^2 times as much.

   Why leave out what is below three errors? There e/y is no small number,
   and the logarithm of a noisy y errs further downwards than upwards; some
   y are negative and have none. Keeping those that happen to be
   positive keeps the lucky ones and makes the tail too high. The cut does
   the same in a small way: near y = 3 e it keeps the high ones. But such
   points have weight 9, and the early ones have hundreds.

   The loop below updates the means and the two sums point by point. The
   means move by the weight's share of the step; one factor of each product
   is measured from the mean before, the other from the mean after.

   Another way: the five sums of w, w t, w ln y, w t^2, w t ln y and a
   system of two equations. That is quick to write and loses digits when
   all times are far from zero. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool decay_time(size_t n, const double t[], const double share[],
                const double error[], double limit, double *tau,
                double *sigma)
{
    double weights = 0.0, time = 0.0, height = 0.0; /* weighted means */
    double tt = 0.0, th = 0.0; /* weighted sums of products */
    for (size_t i = n; i-- > 0;) {
        const double y = share[i] - limit, sure = y / error[i];
        if (!(sure > 3.0))
            continue;
        const double w = sure * sure;
        const double step = t[i] - time;
        weights += w;
        time += w / weights * step;
        height += w / weights * (log(y) - height);
        tt += w * step * (t[i] - time);
        th += w * step * (log(y) - height);
    }
    if (!(tt > 0.0 && th < 0.0))
        return false;
    *tau = -tt / th;
    *sigma = *tau * *tau / sqrt(tt);
    return true;
}
