/* mistake: ran-away */

#include "exercise.h"
#include <math.h>

double eccentric_anomaly(double e, double mean)
{
    double E = mean;
    for (int i = 0; i < 100; ++i)
        E -= (E - e * sin(E) - mean) / (1 - e * cos(E));
    return E;
}
