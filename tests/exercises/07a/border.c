/* What crosses the border of exercise 07a: see examiner/border.h. */
/* place: speed_below fourth 1 */

#include "examiner/border.h"

double speed_below(int n, double mean_square, double v, double *fourth);

/* The arguments; the fourth power follows. */
struct call {
    int n;
    double mean_square, v;
};

static void move_arguments(struct call *c)
{
    border_ints(&c->n, 1);
    border_doubles(&c->mean_square, 1);
    border_doubles(&c->v, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *fourth = border_place_doubles("fourth", 1);
    double below = speed_below(c.n, c.mean_square, c.v, fourth);
    border_reply();
    border_doubles(&below, 1);
    border_doubles(fourth, 1);
}

#else

double speed_below(int n, double mean_square, double v, double *fourth)
{
    struct call c = {n, mean_square, v};
    double below;
    border_call();
    move_arguments(&c);
    border_doubles(fourth, 1);
    border_wait();
    border_doubles(&below, 1);
    border_doubles(fourth, 1);
    return below;
}

#endif
