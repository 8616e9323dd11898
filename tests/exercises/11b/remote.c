/* The remote calls of exercise 11b: see examiner/remote.h. With the
   balls comes one behind the last: the suite has put something there. */
/* output: cradle v n suite */

#include "examiner/remote.h"
#include <stdlib.h>
#include <string.h>

size_t cradle(size_t n, const double mass[], double v[]);

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    size_t n;
    remote_sizes(&n, 1);
    double *mass = remote_array((n + 1), sizeof *mass);
    remote_doubles(mass, n + 1);
    double *v = remote_output_doubles("v", n + 1);
    size_t collisions = cradle(n, mass, v);
    remote_reply();
    remote_sizes(&collisions, 1);
    remote_doubles(v, n + 1);
    free(mass);
}

#else

size_t cradle(size_t n, const double mass[], double v[])
{
    size_t collisions, count = n;
    double *copy = remote_array((n + 1), sizeof *copy);
    memcpy(copy, mass, (n + 1) * sizeof *copy);
    remote_call();
    remote_sizes(&count, 1);
    remote_doubles(copy, n + 1);
    remote_doubles(v, n + 1);
    free(copy);
    remote_wait();
    remote_sizes(&collisions, 1);
    remote_doubles(v, n + 1);
    return collisions;
}

#endif
