/* mistake: digits-lost */

#include "exercise.h"
#include <math.h>

double speed_below(int n, double mean_square, double v, double *fourth)
{
    double x = v * v / (n * mean_square), m = mean_square;
    double p = 1, q;
    int k;
    *fourth = 2.0 * n / (n + 1) * m * m;
    if (v <= 0)
        return 0;
    if (x >= 1)
        return 1;
    for (q = 1 - x, k = n - 1; k > 0; k /= 2, q *= q)
        if (k % 2 == 1)
            p *= q;
    return 1 - p;
}
