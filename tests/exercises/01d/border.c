/* What crosses the border of exercise 01d: see examiner/border.h. */
/* place: none */

#include "examiner/border.h"

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection);

struct call {
    double r1, r2, im1, im2, deflection;
};

static void move_arguments(struct call *c)
{
    border_doubles(&c->r1, 1);
    border_doubles(&c->r2, 1);
    border_doubles(&c->im1, 1);
    border_doubles(&c->im2, 1);
    border_doubles(&c->deflection, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double b = impact_parameter(c.r1, c.r2, c.im1, c.im2, c.deflection);
    border_reply();
    border_doubles(&b, 1);
}

#else

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection)
{
    struct call c = {r1, r2, im1, im2, deflection};
    double b;
    border_call();
    move_arguments(&c);
    border_wait();
    border_doubles(&b, 1);
    return b;
}

#endif
