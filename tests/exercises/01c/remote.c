/* The remote calls of exercise 01c: see examiner/remote.h. */
/* output: none */

#include "examiner/remote.h"
#include <stdlib.h>

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution);

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    size_t n;
    double speed, restitution, velocity;
    remote_sizes(&n, 1);
    double *masses = remote_array(n, sizeof masses[0]);
    remote_doubles(masses, n);
    remote_doubles(&speed, 1);
    remote_doubles(&restitution, 1);
    velocity = top_velocity(n, masses, speed, restitution);
    free(masses);
    remote_reply();
    remote_doubles(&velocity, 1);
}

#else

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution)
{
    double velocity;
    remote_call();
    remote_sizes(&n, 1);
    remote_doubles((double *)masses, n);
    remote_doubles(&speed, 1);
    remote_doubles(&restitution, 1);
    remote_wait();
    remote_doubles(&velocity, 1);
    return velocity;
}

#endif
