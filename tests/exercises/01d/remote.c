/* The remote calls of exercise 01d: see examiner/remote.h. */
/* output: none */

#include "examiner/remote.h"

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection);

struct call {
    double r1, r2, im1, im2, deflection;
};

static void move_arguments(struct call *c)
{
    remote_doubles(&c->r1, 1);
    remote_doubles(&c->r2, 1);
    remote_doubles(&c->im1, 1);
    remote_doubles(&c->im2, 1);
    remote_doubles(&c->deflection, 1);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    double b = impact_parameter(c.r1, c.r2, c.im1, c.im2, c.deflection);
    remote_reply();
    remote_doubles(&b, 1);
}

#else

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection)
{
    struct call c = {r1, r2, im1, im2, deflection};
    double b;
    remote_call();
    move_arguments(&c);
    remote_wait();
    remote_doubles(&b, 1);
    return b;
}

#endif
