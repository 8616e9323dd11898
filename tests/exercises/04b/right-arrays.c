/* A right answer: first pick the points, then the means, then the line. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>

struct point {
    double t, log, weight;
};

static bool line(const struct point *first, const struct point *end,
                 double *slope, double *variance)
{
    const struct point *p;
    double all = 0, spread = 0, tilt = 0;
    double t = 0, l = 0;
    for (p = first; p != end; p++) {
        all += p->weight;
        t += p->weight * p->t;
        l += p->weight * p->log;
    }
    t /= all;
    l /= all;
    for (p = first; p != end; p++) {
        spread += p->weight * (p->t - t) * (p->t - t);
        tilt += p->weight * (p->t - t) * (p->log - l);
    }
    *slope = tilt / spread;
    *variance = 1 / spread;
    return spread > 0;
}

bool decay_time(size_t n, const double t[], const double share[],
                const double error[], double limit, double *tau,
                double *sigma)
{
    struct point *points = malloc((n + 1) * sizeof *points), *end = points;
    double slope, variance;
    size_t i;
    bool falls;
    if (!points)
        return false;
    for (i = 0; i < n; i++) {
        double ratio = (share[i] - limit) / error[i];
        if (ratio > 3) {
            end->t = t[i];
            end->log = log(share[i] - limit);
            end->weight = ratio * ratio;
            end++;
        }
    }
    falls =
        end > points && line(points, end, &slope, &variance) && slope < 0;
    free(points);
    if (!falls)
        return false;
    *tau = -1 / slope;
    *sigma = *tau * *tau * sqrt(variance);
    return true;
}
