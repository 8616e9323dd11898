/* mistake: masses-ignored */

#include "exercise.h"
#include <stddef.h>

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution)
{
    double w = restitution * speed;
    (void)masses;
    while (--n > 0)
        w = -speed + (1 + restitution) * (w + speed);
    return w;
}
