/* The remote calls of exercise 01a: see examiner/remote.h. */
/* output: velocities_after v 2 */

#include "examiner/remote.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2]);

/* The arguments; v follows. */
struct call {
    double u1, u2, im1, im2;
};

static void move_arguments(struct call *c)
{
    remote_doubles(&c->u1, 1);
    remote_doubles(&c->u2, 1);
    remote_doubles(&c->im1, 1);
    remote_doubles(&c->im2, 1);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    double *v = remote_output_doubles("v", 2);
    velocities_after(c.u1, c.u2, c.im1, c.im2, v);
    remote_reply();
    remote_doubles(v, 2);
}

#else

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    struct call c = {u1, u2, im1, im2};
    remote_call();
    move_arguments(&c);
    remote_doubles(v, 2);
    remote_wait();
    remote_doubles(v, 2);
}

#endif
