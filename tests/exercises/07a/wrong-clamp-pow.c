/* mistake: not-clamped */

#include "exercise.h"
#include <math.h>

double speed_below(int n, double mean_square, double v, double *fourth)
{
    double x = v * v / (n * mean_square), m = mean_square;
    *fourth = 2.0 * n / (n + 1) * m * m;
    if (v <= 0)
        return 0;
    return 1 - pow(1 - x, n - 1);
}
