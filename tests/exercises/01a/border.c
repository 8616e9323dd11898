/* What crosses the border of exercise 01a: see examiner/border.h. */
/* place: velocities_after v 2 */

#include "examiner/border.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2]);

/* The arguments; v follows. */
struct call {
    double u1, u2, im1, im2;
};

static void move_arguments(struct call *c)
{
    border_doubles(&c->u1, 1);
    border_doubles(&c->u2, 1);
    border_doubles(&c->im1, 1);
    border_doubles(&c->im2, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *v = border_place_doubles("v", 2);
    velocities_after(c.u1, c.u2, c.im1, c.im2, v);
    border_reply();
    border_doubles(v, 2);
}

#else

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    struct call c = {u1, u2, im1, im2};
    border_call();
    move_arguments(&c);
    border_doubles(v, 2);
    border_wait();
    border_doubles(v, 2);
}

#endif
