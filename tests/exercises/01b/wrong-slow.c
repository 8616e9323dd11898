/* mistake: slow-taken-for-alike */
/* Two that approach at less than 1e-9 m/s are taken for two that move
 * alike. Found by a trial of the second edition, when it earned full
 * points. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution)
{
    const double loss = u1 - v1; /* of the first body */
    const double gain = v2 - u2; /* of the second */
    if (fabs(u1 - u2) < 1e-9 || (loss == 0.0 && gain == 0.0))
        return false;
    if ((loss > 0.0 && gain < 0.0) || (loss < 0.0 && gain > 0.0))
        return false;
    *mass_ratio = fabs(gain) / fabs(loss);
    *restitution = (v2 - v1) / (u1 - u2);
    return true;
}
