/* 02a crashed: right, but looks at one velocity behind the last */
#include "exercise.h"
#include <math.h>
#include <stddef.h>

double next_meeting(size_t n, double length, const double x[],
                    const double v[], size_t *left)
{
    double soonest = INFINITY;
    double ahead = x[0] + length, flees = v[0];
    volatile double more = v[n];
    (void)more;
    for (size_t i = n; i-- > 0; ahead = x[i], flees = v[i]) {
        if (v[i] <= flees)
            continue;
        const double wait = fmax(0.0, ahead - x[i]) / (v[i] - flees);
        if (wait <= soonest) {
            soonest = wait;
            *left = i;
        }
    }
    return soonest;
}
