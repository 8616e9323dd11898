/* mistake: masses-exchanged */

#include "exercise.h"
#include <stddef.h>

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution)
{
    double w = restitution * speed;
    size_t k;
    for (k = n - 1; k > 0; k--)
        w = -speed + (1 + restitution) * masses[k] /
                         (masses[k] + masses[k - 1]) * (w + speed);
    return w;
}
