/* mistake: none */
/* unnamed: looked-once */

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

        for (j = 0; j < i; j++)
            if (throws == 1 && hits(i, j, radius, x, y)) {
                throws = 2;
                i = (size_t)-1;
                break;
            }
    }
    return throws;
}
