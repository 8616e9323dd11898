/* The remote calls of exercise 02c: see examiner/remote.h. */
/* output: positions_at x n */
/* output: positions_at v n */

#include "examiner/remote.h"
#include <stdlib.h>

void positions_at(size_t n, double length, const double x0[],
                  const double v0[], double t, double x[], double v[]);

#ifdef REMOTE_SERVER

static double *taken(size_t n)
{
    double *numbers = remote_array(n, sizeof numbers[0]);
    remote_doubles(numbers, n);
    return numbers;
}

void remote_serve(void)
{
    size_t n;
    double length, t;
    remote_sizes(&n, 1);
    remote_doubles(&length, 1);
    remote_doubles(&t, 1);
    double *x0 = taken(n), *v0 = taken(n);
    double *x = remote_output_doubles("x", n);
    double *v = remote_output_doubles("v", n);
    positions_at(n, length, x0, v0, t, x, v);
    free(x0);
    free(v0);
    remote_reply();
    remote_doubles(x, n);
    remote_doubles(v, n);
}

#else

void positions_at(size_t n, double length, const double x0[],
                  const double v0[], double t, double x[], double v[])
{
    remote_call();
    remote_sizes(&n, 1);
    remote_doubles(&length, 1);
    remote_doubles(&t, 1);
    remote_doubles((double *)x0, n);
    remote_doubles((double *)v0, n);
    remote_doubles(x, n);
    remote_doubles(v, n);
    remote_wait();
    remote_doubles(x, n);
    remote_doubles(v, n);
}

#endif
