/* mistake: relative-error */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool decay_time(size_t n, const double t[], const double share[],
                const double error[], double limit, double *tau,
                double *sigma)
{
    double s = 0, st = 0, sl = 0, stt = 0, stl = 0, d, b, sb;
    size_t i;
    for (i = 0; i < n; i++) {
        double y = share[i] - limit, e = error[i], w, l;
        if (y <= 3 * e)
            continue;
        l = log(y);
        w = y / e * y / e;
        s += w;
        st += w * t[i];
        sl += w * l;
        stt += w * t[i] * t[i];
        stl += w * t[i] * l;
    }
    d = s * stt - st * st;
    if (d == 0 || s * stl - st * sl >= 0)
        return false;
    b = (s * stl - st * sl) / d;
    sb = sqrt(s / d);
    *tau = -1 / b;
    *sigma = -sb / b;
    return true;
}
