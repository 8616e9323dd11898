/* mistake: digits-cancelled */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool error_by_blocks(size_t n, const double x[], size_t length,
                     double *error, double *inefficiency)
{
    double s = 0, ss = 0, t = 0, tt = 0, b, m;
    size_t i, j;
    if (length == 0 || n / length < 2)
        return false;
    for (i = 0; i < n / length; i++) {
        double mean = 0;
        for (j = i * length; j < (i + 1) * length; j++) {
            mean += x[j] / (double)length;
            s += x[j];
            ss += x[j] * x[j];
        }
        t += mean;
        tt += mean * mean;
    }
    b = (double)(n / length);
    m = b * (double)length;
    *error = sqrt((tt / b - t / b * t / b) / (b - 1));
    *inefficiency = *error * *error / ((ss / m - s / m * s / m) / (m - 1));
    return true;
}
