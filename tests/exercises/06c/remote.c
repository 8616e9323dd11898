/* The remote calls of exercise 06c: see examiner/remote.h. */
/* output: depletion overlap 1 */

#include "examiner/remote.h"

double depletion(int dimensions, double R1, double R2, double small,
                 double density, double r, double *overlap);

/* The arguments; the overlap follows. */
struct call {
    int dimensions;
    double R1, R2, small, density, r;
};

static void move_arguments(struct call *c)
{
    remote_ints(&c->dimensions, 1);
    remote_doubles(&c->R1, 1);
    remote_doubles(&c->R2, 1);
    remote_doubles(&c->small, 1);
    remote_doubles(&c->density, 1);
    remote_doubles(&c->r, 1);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    double *overlap = remote_output_doubles("overlap", 1);
    double potential = depletion(c.dimensions, c.R1, c.R2, c.small,
                                 c.density, c.r, overlap);
    remote_reply();
    remote_doubles(&potential, 1);
    remote_doubles(overlap, 1);
}

#else

double depletion(int dimensions, double R1, double R2, double small,
                 double density, double r, double *overlap)
{
    struct call c = {dimensions, R1, R2, small, density, r};
    double potential;
    remote_call();
    move_arguments(&c);
    remote_doubles(overlap, 1);
    remote_wait();
    remote_doubles(&potential, 1);
    remote_doubles(overlap, 1);
    return potential;
}

#endif
