/* mistake: never-refuses */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool decay_time(size_t n, const double t[], const double share[],
                const double error[], double limit, double *tau,
                double *sigma)
{
    double s = 0, st = 0, sl = 0, stt = 0, stl = 0, b;
    size_t i;
    for (i = 0; i < n; i++) {
        double y = share[i] - limit, e = error[i], w = y / e * y / e;
        if (y <= 3 * e)
            continue;
        s += w;
        st += w * t[i];
        sl += w * log(y);
        stt += w * t[i] * t[i];
        stl += w * t[i] * log(y);
    }
    b = (s * stl - st * sl) / (s * stt - st * st);
    *tau = -1 / b;
    *sigma = sqrt(s / (s * stt - st * st)) / b / b;
    return true;
}
