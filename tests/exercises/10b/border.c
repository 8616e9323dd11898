/* What crosses the border of exercise 10b: see examiner/border.h. */
/* place: oscillate velocity 1 */

#include "examiner/border.h"

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
    border_doubles(&o->mass, 1);
    border_doubles(&o->damping, 1);
    border_doubles(&o->stiffness, 1);
    border_doubles(&o->x, 1);
    border_doubles(&o->v, 1);
    border_doubles(t, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct oscillator o;
    double t;
    move_arguments(&o, &t);
    double *velocity = border_place_doubles("velocity", 1);
    double x = oscillate(&o, t, velocity);
    border_reply();
    border_doubles(&x, 1);
    border_doubles(velocity, 1);
}

#else

double oscillate(const struct oscillator *o, double t, double *velocity)
{
    struct oscillator copy = *o;
    double x;
    border_call();
    move_arguments(&copy, &t);
    border_doubles(velocity, 1);
    border_wait();
    border_doubles(&x, 1);
    border_doubles(velocity, 1);
    return x;
}

#endif
