/* What crosses the border of exercise 01b: see examiner/border.h. */

#include "examiner/border.h"

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution);

/* The arguments, and the places for the answer as they are before. */
struct call {
    double u1, u2, v1, v2;
    double mass_ratio, restitution;
};

static void move_places(struct call *c)
{
    border_doubles(&c->mass_ratio, 1);
    border_doubles(&c->restitution, 1);
}

static void move_arguments(struct call *c)
{
    border_doubles(&c->u1, 1);
    border_doubles(&c->u2, 1);
    border_doubles(&c->v1, 1);
    border_doubles(&c->v2, 1);
    move_places(c);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    bool told = measure_collision(c.u1, c.u2, c.v1, c.v2, &c.mass_ratio,
                                  &c.restitution);
    border_reply();
    border_bools(&told, 1);
    move_places(&c);
}

#else

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution)
{
    struct call c = {u1, u2, v1, v2, *mass_ratio, *restitution};
    bool told = false;
    border_call();
    move_arguments(&c);
    border_wait();
    border_bools(&told, 1);
    move_places(&c);
    *mass_ratio = c.mass_ratio;
    *restitution = c.restitution;
    return told;
}

#endif
