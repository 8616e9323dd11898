/* mistake: rest-taken-for-a-block */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool error_by_blocks(size_t n, const double x[], size_t length,
                     double *error, double *inefficiency)
{
    double sums[3][3] = {{0}}, block = 0;
    size_t i, j = 0;
    int k;
    if (length == 0 || n / length < 2)
        return false;
    for (i = 0; i < n; i++) {
        double d = x[i] - x[0];
        sums[0][0] += 1;
        sums[0][1] += d;
        sums[0][2] += d * d;
        block += d;
        j++;
        if (j == length || i + 1 == n) {
            block /= (double)j;
            sums[1][0] += 1;
            sums[1][1] += block;
            sums[1][2] += block * block;
            block = 0;
            j = 0;
        }
    }
    for (k = 0; k < 2; k++) {
        double m = sums[k][1] / sums[k][0];
        sums[k][2] -= sums[k][0] * m * m;
        sums[k][2] /= sums[k][0] * (sums[k][0] - 1);
    }
    *error = sqrt(sums[1][2]);
    *inefficiency = sums[1][2] / sums[0][2];
    return true;
}
