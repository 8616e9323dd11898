/* mistake: only-the-last-pair */

#include "exercise.h"
#include <stddef.h>

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution)
{
    double up = restitution * speed;
    double a, b;
    if (n == 1)
        return up;
    a = masses[n - 2];
    b = masses[n - 1];
    return -speed + (1 + restitution) * a / (a + b) * (up + speed);
}
