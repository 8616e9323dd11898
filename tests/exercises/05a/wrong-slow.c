/* mistake: slow-taken-for-at-rest */
/* A square of a speed below 1e-12 is taken for a disk at rest. Found by a
 * trial of the second edition, when it earned full points. */

#include "exercise.h"
#include <math.h>

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2])
{
    const double reach = box - radius;
    const double x = r[0], y = r[1], u = v[0], w = v[1];
    const double room = reach * reach - (x * x + y * y);
    const double outward = x * u + y * w, speed_squared = u * u + w * w;
    if (speed_squared < 1e-12)
        return INFINITY;
    const double root =
        sqrt(fmax(0.0, outward * outward + speed_squared * room));
    if (outward > 0.0)
        return fmax(0.0, room) / (outward + root);
    return (root - outward) / speed_squared;
}
