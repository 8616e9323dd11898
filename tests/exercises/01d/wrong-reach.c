/* mistake: out-of-reach */

#include "exercise.h"
#include <math.h>

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection)
{
    double chi = deflection + asin(im2 / im1 * sin(deflection));
    return (r1 + r2) * cos(chi / 2);
}
