/* mistake: stable-step-refused */
/* An eigenvalue has to be less than 1. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

void step(double h, double y[2]);

static bool stable(double h)
{
    double first[2] = {1.0, 0.0}, second[2] = {0.0, 1.0};
    step(h, first);
    step(h, second);
    const double trace = first[0] + second[1];
    const double det = first[0] * second[1] - second[0] * first[1];
    const double under = trace * trace - 4.0 * det;
    const double largest =
        under < 0.0 ? sqrt(det) : 0.5 * (fabs(trace) + sqrt(under));
    return largest < 1.0;
}

double stability_limit(double most)
{
    double low = 0.0, high = INFINITY;
    for (int i = 1; 0.01 * i <= most && isinf(high); ++i)
        if (stable(0.01 * i))
            low = 0.01 * i;
        else
            high = 0.01 * i;
    if (isinf(high) || low <= 0.0)
        return isinf(high) ? INFINITY : 0.0;
    while (high - low >= 1e-10) {
        const double middle = 0.5 * (low + high);
        if (stable(middle))
            low = middle;
        else
            high = middle;
    }
    return low;
}
