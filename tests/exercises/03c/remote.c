/* The remote calls of exercise 03c: see examiner/remote.h. */
/* output: none */

#include "examiner/remote.h"

double velocity_below(int n, double u);

static void move_arguments(int *n, double *u)
{
    remote_ints(n, 1);
    remote_doubles(u, 1);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    int n;
    double u;
    move_arguments(&n, &u);
    double below = velocity_below(n, u);
    remote_reply();
    remote_doubles(&below, 1);
}

#else

double velocity_below(int n, double u)
{
    double below;
    remote_call();
    move_arguments(&n, &u);
    remote_wait();
    remote_doubles(&below, 1);
    return below;
}

#endif
