/* mistake: square-box */

#include "exercise.h"
#include <math.h>

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2])
{
    double s = box - radius, t = INFINITY;
    int i;
    for (i = 0; i < 2; i++) {
        if (v[i] > 0)
            t = fmin(t, (s - r[i]) / v[i]);
        if (v[i] < 0)
            t = fmin(t, (-s - r[i]) / v[i]);
    }
    return t > 0 ? t : 0;
}
