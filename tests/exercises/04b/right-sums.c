/* A right answer: five sums and two equations. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool decay_time(size_t n, const double t[], const double share[],
                const double error[], double limit, double *tau,
                double *sigma)
{
    double s = 0, d, slope;
    double st = 0, sl = 0;
    double stt = 0, stl = 0;
    while (n-- > 0) {
        double y = share[n] - limit, from = t[n] - t[0], e, l;
        if (y <= 3 * error[n])
            continue;
        e = error[n] / y;
        l = log(y);
        s += 1 / e / e;
        st += from / e / e;
        sl += l / e / e;
        stt += from * from / e / e;
        stl += from * l / e / e;
    }
    d = s * stt - st * st;
    if (d <= 1e-12 * s * stt)
        return false;
    slope = (s * stl - st * sl) / d;
    if (slope >= 0)
        return false;
    *tau = -1 / slope;
    *sigma = sqrt(s / d) / (slope * slope);
    return true;
}
