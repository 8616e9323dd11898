/* mistake: density-for-distribution */

#include "exercise.h"
#include <math.h>

static double constant(int n)
{
    return tgamma(n / 2.0) / tgamma((n - 1) / 2.0) / sqrt(acos(-1));
}

double velocity_below(int n, double u)
{
    if (u <= -1)
        return 0;
    if (u >= 1)
        return 1;
    return constant(n) * pow(1 - u * u, (n - 3) / 2.0);
}
