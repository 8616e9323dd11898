/* mistake: whole-for-half */

#include "exercise.h"
#include <math.h>

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection)
{
    double ratio = im2 / im1;
    double s = ratio * sin(deflection);
    if (s > 1 || (ratio >= 1 && cos(deflection) < 0))
        return -1;
    return (r1 + r2) * cos(deflection + asin(s));
}
