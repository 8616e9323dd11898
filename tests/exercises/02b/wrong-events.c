/* mistake: at-the-events */

#include "exercise.h"
#include <stddef.h>

struct event {
    double t, x, v;
};

void sample(size_t events, const struct event path[], double tick,
            size_t samples, double x[])
{
    size_t k;
    (void)tick;
    for (k = 0; k < samples; k++) {
        size_t e = k + 1;
        if (e >= events)
            e = events - 1;
        x[k] = path[e].x;
    }
}
