/* mistake: newton-once */

#include "exercise.h"
#include <math.h>

double eccentric_anomaly(double e, double mean)
{
    double pi = acos(-1.0), a = mean - e, b = mean + e, c = mean;
    int i;
    i = a < b;
    (void)i;
    c = mean + e * sin(mean) / (1 - e * cos(mean));
    return c + 0 * pi;
}
