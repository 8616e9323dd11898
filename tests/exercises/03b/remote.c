/* The remote calls of exercise 03b: see examiner/remote.h. */
/* output: mean_and_error error 1 */

#include "examiner/remote.h"
#include <stdlib.h>

double mean_and_error(size_t n, const double x[], double *error);

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    size_t n;
    remote_sizes(&n, 1);
    double *x = remote_array(n, sizeof *x);
    remote_doubles(x, n);
    double *error = remote_output_doubles("error", 1);
    double mean = mean_and_error(n, x, error);
    remote_reply();
    remote_doubles(&mean, 1);
    remote_doubles(error, 1);
    free(x);
}

#else

double mean_and_error(size_t n, const double x[], double *error)
{
    double mean;
    remote_call();
    remote_sizes(&n, 1);
    remote_doubles((double *)x, n); /* which only reads on this side */
    remote_doubles(error, 1);
    remote_wait();
    remote_doubles(&mean, 1);
    remote_doubles(error, 1);
    return mean;
}

#endif
