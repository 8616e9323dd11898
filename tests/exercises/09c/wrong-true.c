/* mistake: true-anomaly */

#include "exercise.h"
#include <math.h>

double eccentric_anomaly(double e, double mean)
{
    double pi = acos(-1.0), a = mean - e, b = mean + e, c = mean;
    int i;
    for (i = 0; i < 200; i++) {
        c = (a + b) / 2;
        if (c - e * sin(c) < mean)
            a = c;
        else
            b = c;
    }
    return c + 2 * atan(sqrt((1 + e) / (1 - e)) * tan(c / 2)) -
           2 * atan(tan(c / 2)) + 0 * pi;
}
