/* mistake: ran-away */

#include "exercise.h"
#include <math.h>

double eccentric_anomaly(double e, double mean)
{
    double pi = acos(-1.0), a = mean - e, b = mean + e, c = mean;
    int i;
    i = a < b;
    (void)i;
    for (i = 0; i < 8; i++)
        c -= (c - e * sin(c) - mean) / (1 - e * cos(c));
    return c + 0 * pi;
}
