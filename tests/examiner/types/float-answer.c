/* 02a does not build: its answer is a float; found by a trial of the second edition */
/* says: .c:8:7: error: conflicting types */
/* says: next_meeting has other types than the exercise gave: double next_meeting(size_t n, double length, const double x[], const double v[], size_t *left) */
#include "exercise.h"
#include <math.h>
#include <stddef.h>

float next_meeting(size_t n, double length, const double x[],
                   const double v[], size_t *left)
{
    double soonest = INFINITY;
    double ahead = x[0] + length;
    double flees = v[0];
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
