/* What crosses the border of exercise 10a: see examiner/border.h. */
/* place: dashpot on_a 3 */
/* place: dashpot on_b 3 */

#include "examiner/border.h"

struct body {
    double x[3];
    double v[3];
};

double dashpot(double c, const struct body *a, const struct body *b,
               double on_a[3], double on_b[3]);

/* The arguments; the two forces follow. */
struct call {
    double c;
    struct body a, b;
};

static void move_arguments(struct call *c)
{
    border_doubles(&c->c, 1);
    border_doubles(c->a.x, 3);
    border_doubles(c->a.v, 3);
    border_doubles(c->b.x, 3);
    border_doubles(c->b.v, 3);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    const struct body a = c.a, b = c.b;
    double *on_a = border_place_doubles("on_a", 3);
    double *on_b = border_place_doubles("on_b", 3);
    double heat = dashpot(c.c, &a, &b, on_a, on_b);
    border_reply();
    border_doubles(&heat, 1);
    border_doubles(on_a, 3);
    border_doubles(on_b, 3);
}

#else

double dashpot(double c, const struct body *a, const struct body *b,
               double on_a[3], double on_b[3])
{
    struct call call = {c, *a, *b};
    double heat;
    border_call();
    move_arguments(&call);
    border_doubles(on_a, 3);
    border_doubles(on_b, 3);
    border_wait();
    border_doubles(&heat, 1);
    border_doubles(on_a, 3);
    border_doubles(on_b, 3);
    return heat;
}

#endif
