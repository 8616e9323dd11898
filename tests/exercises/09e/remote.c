/* The remote calls of exercise 09e: see examiner/remote.h. */
/* output: none */

#include "examiner/remote.h"
#include <stdlib.h>

double sum_up(size_t n, const double part[]);

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    size_t n;
    remote_sizes(&n, 1);
    double *part = remote_array(n, sizeof *part);
    remote_doubles(part, n);
    double sum = sum_up(n, part);
    remote_reply();
    remote_doubles(&sum, 1);
    free(part);
}

#else

double sum_up(size_t n, const double part[])
{
    double sum;
    remote_call();
    remote_sizes(&n, 1);
    remote_doubles((double *)part, n); /* which only reads on this side */
    remote_wait();
    remote_doubles(&sum, 1);
    return sum;
}

#endif
