/* mistake: stopped-too-soon */
/* Ten steps, whatever the ellipse is. */

#include "exercise.h"
#include <math.h>

double eccentric_anomaly(double e, double mean)
{
    const double pi = acos(-1.0);
    const double within = remainder(mean, 2.0 * pi), m = fabs(within);
    double last = fmin(m + e, pi);
    for (int i = 0; i < 10; ++i)
        last = last - (last - e * sin(last) - m) / (1.0 - e * cos(last));
    return mean + copysign(last - m, within);
}
