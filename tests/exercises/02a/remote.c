/* The remote calls of exercise 02a: see examiner/remote.h. */
/* output: next_meeting left 1 */

#include "examiner/remote.h"
#include <stdlib.h>

double next_meeting(size_t n, double length, const double x[],
                    const double v[], size_t *left);

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    size_t n;
    double length, time;
    remote_sizes(&n, 1);
    remote_doubles(&length, 1);
    double *x = remote_array(n, sizeof x[0]);
    double *v = remote_array(n, sizeof v[0]);
    remote_doubles(x, n);
    remote_doubles(v, n);
    size_t *left = remote_output_sizes("left", 1);
    time = next_meeting(n, length, x, v, left);
    free(x);
    free(v);
    remote_reply();
    remote_doubles(&time, 1);
    remote_sizes(left, 1);
}

#else

double next_meeting(size_t n, double length, const double x[],
                    const double v[], size_t *left)
{
    double time;
    remote_call();
    remote_sizes(&n, 1);
    remote_doubles(&length, 1);
    remote_doubles((double *)x, n);
    remote_doubles((double *)v, n);
    remote_sizes(left, 1);
    remote_wait();
    remote_doubles(&time, 1);
    remote_sizes(left, 1);
    return time;
}

#endif
