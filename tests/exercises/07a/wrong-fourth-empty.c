/* mistake: left-empty */

#include "exercise.h"
#include <math.h>

double speed_below(int n, double mean_square, double v, double *fourth)
{
    double x = v * v / (n * mean_square);
    (void)fourth;
    if (v <= 0)
        return 0;
    if (x >= 1)
        return 1;
    return -expm1((n - 1) * log1p(-x));
}
