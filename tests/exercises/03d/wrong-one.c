/* mistake: never-refuses */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool error_by_blocks(size_t n, const double x[], size_t length,
                     double *error, double *inefficiency)
{
    double m = 0, by_value = 0, by_block = 0, b;
    size_t i, j, used;
    if (length == 0 || length > n)
        return false;
    b = (double)(n / length);
    used = n / length * length;
    for (i = 0; i < used; i++)
        m += (x[i] - m) / ((double)i + 1);
    for (i = 0; i < used; i += length) {
        double sum = 0;
        for (j = i; j < i + length; j++) {
            sum += (x[j] - m) / (double)length;
            by_value += (x[j] - m) * (x[j] - m);
        }
        by_block += sum * sum;
    }
    *error = sqrt(by_block / b / (b - 1));
    *inefficiency = by_block / b / (b - 1) /
                    (by_value / (double)used / ((double)used - 1));
    return true;
}
