/* What crosses the border of exercise 10b: see examiner/border.h. */

#include "examiner/border.h"

struct oscillator {
    double mass;
    double damping;
    double stiffness;
    double x;
    double v;
};

double oscillate(const struct oscillator *o, double t, double *velocity);

/* The arguments, and the place for the velocity as it is before. */
static void move_arguments(struct oscillator *o, double *t,
                           double *velocity)
{
    border_doubles(&o->mass, 1);
    border_doubles(&o->damping, 1);
    border_doubles(&o->stiffness, 1);
    border_doubles(&o->x, 1);
    border_doubles(&o->v, 1);
    border_doubles(t, 1);
    border_doubles(velocity, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct oscillator o;
    double t, velocity;
    move_arguments(&o, &t, &velocity);
    double x = oscillate(&o, t, &velocity);
    border_reply();
    border_doubles(&x, 1);
    border_doubles(&velocity, 1);
}

#else

double oscillate(const struct oscillator *o, double t, double *velocity)
{
    struct oscillator copy = *o;
    double x;
    border_call();
    move_arguments(&copy, &t, velocity);
    border_wait();
    border_doubles(&x, 1);
    border_doubles(velocity, 1);
    return x;
}

#endif
