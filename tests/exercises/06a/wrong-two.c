/* mistake: two-thrown-again */

#include "exercise.h"
#include <stddef.h>

double uniform(void);

static int hits(size_t i, size_t j, const double r[], const double x[],
                const double y[])
{
    double dx = x[i] - x[j], dy = y[i] - y[j];
    return dx * dx + dy * dy < (r[i] + r[j]) * (r[i] + r[j]);
}

size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[])
{
    size_t i, j, throws = 1;
    for (i = 0; i < n; i++) {
        x[i] = radius[i] + (width - 2 * radius[i]) * uniform();
        y[i] = radius[i] + (height - 2 * radius[i]) * uniform();
    }
    for (i = 0; i < n; i++)
        for (j = 0; j < i; j++)
            if (hits(i, j, radius, x, y)) {
                x[j] = radius[j] + (width - 2 * radius[j]) * uniform();
                y[j] = radius[j] + (height - 2 * radius[j]) * uniform();
                x[i] = radius[i] + (width - 2 * radius[i]) * uniform();
                y[i] = radius[i] + (height - 2 * radius[i]) * uniform();
                throws++;
                i = j = 0;
            }
    return throws;
}
