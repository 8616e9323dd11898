/* What crosses the border of exercise 01c: see examiner/border.h. */
/* place: none */

#include "examiner/border.h"
#include <stdlib.h>

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution);

#ifdef BORDER_INSIDE

void border_answer(void)
{
    size_t n;
    double speed, restitution, velocity;
    border_sizes(&n, 1);
    double *masses = border_array(n, sizeof masses[0]);
    border_doubles(masses, n);
    border_doubles(&speed, 1);
    border_doubles(&restitution, 1);
    velocity = top_velocity(n, masses, speed, restitution);
    free(masses);
    border_reply();
    border_doubles(&velocity, 1);
}

#else

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution)
{
    double velocity;
    border_call();
    border_sizes(&n, 1);
    border_doubles((double *)masses, n);
    border_doubles(&speed, 1);
    border_doubles(&restitution, 1);
    border_wait();
    border_doubles(&velocity, 1);
    return velocity;
}

#endif
