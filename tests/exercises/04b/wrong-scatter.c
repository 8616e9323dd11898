/* mistake: from-the-scatter */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool decay_time(size_t n, const double t[], const double share[],
                const double error[], double limit, double *tau,
                double *sigma)
{
    double s = 0, mt = 0, ml = 0, tt = 0, tl = 0, rest = 0, b;
    size_t i, m = 0;
    for (i = 0; i < n; i++) {
        double y = share[i] - limit, w = y / error[i] * (y / error[i]);
        if (y > 3 * error[i]) {
            s += w;
            mt += w * t[i];
            ml += w * log(y);
            m++;
        }
    }
    mt /= s;
    ml /= s;
    for (i = 0; i < n; i++) {
        double y = share[i] - limit, w = y / error[i] * (y / error[i]);
        if (y > 3 * error[i]) {
            tt += w * (t[i] - mt) * (t[i] - mt);
            tl += w * (t[i] - mt) * (log(y) - ml);
        }
    }
    if (!(tt > 0 && tl < 0))
        return false;
    b = tl / tt;
    for (i = 0; i < n; i++) {
        double y = share[i] - limit, w = y / error[i] * (y / error[i]);
        if (y > 3 * error[i])
            rest += w * pow(log(y) - ml - b * (t[i] - mt), 2);
    }
    *tau = -1 / b;
    *sigma = sqrt(m > 2 ? rest / ((double)m - 2) / tt : 1 / tt) / b / b;
    return true;
}
