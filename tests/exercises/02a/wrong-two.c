/* mistake: one-pair-of-two */
/* Of two beads there is one pair, and it cannot meet when it touches and
 * parts. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

double next_meeting(size_t n, double length, const double x[],
                    const double v[], size_t *left)
{
    double best = INFINITY;
    if (n == 2 && x[0] >= x[1] && v[0] <= v[1])
        return INFINITY;
    for (size_t i = 0; i < n; i++) {
        size_t j = (i + 1) % n;
        double d = x[j] - x[i] + (j == 0 ? length : 0), w = v[i] - v[j];
        double t = w > 0 ? fmax(d, 0) / w : INFINITY;
        if (t < best) {
            best = t;
            *left = i;
        }
    }
    return best;
}
