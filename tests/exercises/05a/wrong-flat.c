/* mistake: flat-wall */

#include "exercise.h"
#include <math.h>

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2])
{
    double away = hypot(r[0], r[1]);
    double u = (r[0] * v[0] + r[1] * v[1]) / away;
    if (away == 0)
        return (box - radius) / hypot(v[0], v[1]);
    if (u > 0)
        return fmax(0, box - radius - away) / u;
    if (u < 0)
        return (box - radius + away) / -u;
    return INFINITY;
}
