/* mistake: each-pair-once */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

size_t cradle(size_t n, const double mass[], double v[])
{
    double m, M, a, b;
    if (n < 2 || v[0] - v[n - 1] <= 1e-9 * fabs(v[0]))
        return 0;
    m = mass[0];
    M = mass[n - 1];
    a = v[0];
    b = v[n - 1];
    v[0] = a + 2 * M * (b - a) / (m + M);
    v[n - 1] = b - 2 * m * (b - a) / (m + M);
    return n - 1;
}
