/* The remote calls of exercise 10b: see examiner/remote.h. */
/* output: oscillate velocity 1 */

#include "examiner/remote.h"

struct oscillator {
    double mass;
    double damping;
    double stiffness;
    double x;
    double v;
};

double oscillate(const struct oscillator *o, double t, double *velocity);

/* The arguments; the velocity follows. */
static void move_arguments(struct oscillator *o, double *t)
{
    remote_doubles(&o->mass, 1);
    remote_doubles(&o->damping, 1);
    remote_doubles(&o->stiffness, 1);
    remote_doubles(&o->x, 1);
    remote_doubles(&o->v, 1);
    remote_doubles(t, 1);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct oscillator o;
    double t;
    move_arguments(&o, &t);
    double *velocity = remote_output_doubles("velocity", 1);
    double x = oscillate(&o, t, velocity);
    remote_reply();
    remote_doubles(&x, 1);
    remote_doubles(velocity, 1);
}

#else

double oscillate(const struct oscillator *o, double t, double *velocity)
{
    struct oscillator copy = *o;
    double x;
    remote_call();
    move_arguments(&copy, &t);
    remote_doubles(velocity, 1);
    remote_wait();
    remote_doubles(&x, 1);
    remote_doubles(velocity, 1);
    return x;
}

#endif
