/* What crosses the border of exercise 10a: see examiner/border.h. */

#include "examiner/border.h"

struct body {
    double x[3];
    double v[3];
};

double dashpot(double c, const struct body *a, const struct body *b,
               double on_a[3], double on_b[3]);

/* The arguments, and the places for the answer as they are before. */
struct call {
    double c;
    struct body a, b;
    double on_a[3], on_b[3];
};

static void move_arguments(struct call *c)
{
    border_doubles(&c->c, 1);
    border_doubles(c->a.x, 3);
    border_doubles(c->a.v, 3);
    border_doubles(c->b.x, 3);
    border_doubles(c->b.v, 3);
    border_doubles(c->on_a, 3);
    border_doubles(c->on_b, 3);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double heat = dashpot(c.c, &c.a, &c.b, c.on_a, c.on_b);
    border_reply();
    border_doubles(&heat, 1);
    border_doubles(c.on_a, 3);
    border_doubles(c.on_b, 3);
}

#else

double dashpot(double c, const struct body *a, const struct body *b,
               double on_a[3], double on_b[3])
{
    struct call call = {c,
                        *a,
                        *b,
                        {on_a[0], on_a[1], on_a[2]},
                        {on_b[0], on_b[1], on_b[2]}};
    double heat;
    border_call();
    move_arguments(&call);
    border_wait();
    border_doubles(&heat, 1);
    border_doubles(on_a, 3);
    border_doubles(on_b, 3);
    return heat;
}

#endif
