/* The remote calls of exercise 07a: see examiner/remote.h. */
/* output: speed_below fourth 1 */

#include "examiner/remote.h"

double speed_below(int n, double mean_square, double v, double *fourth);

/* The arguments; the fourth power follows. */
struct call {
    int n;
    double mean_square, v;
};

static void move_arguments(struct call *c)
{
    remote_ints(&c->n, 1);
    remote_doubles(&c->mean_square, 1);
    remote_doubles(&c->v, 1);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    double *fourth = remote_output_doubles("fourth", 1);
    double below = speed_below(c.n, c.mean_square, c.v, fourth);
    remote_reply();
    remote_doubles(&below, 1);
    remote_doubles(fourth, 1);
}

#else

double speed_below(int n, double mean_square, double v, double *fourth)
{
    struct call c = {n, mean_square, v};
    double below;
    remote_call();
    move_arguments(&c);
    remote_doubles(fourth, 1);
    remote_wait();
    remote_doubles(&below, 1);
    remote_doubles(fourth, 1);
    return below;
}

#endif
