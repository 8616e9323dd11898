/* What crosses the border of exercise 03a: see examiner/border.h. The law
   stays with the judge; the box asks for it, value by value. */
/* place: equal_bins edge bins+1 */

#include "examiner/border.h"

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[]);

/* The numbers among the arguments; the edges follow, bins + 1 of them. */
struct call {
    double low, high;
    size_t bins;
};

static void move_arguments(struct call *c)
{
    border_doubles(&c->low, 1);
    border_doubles(&c->high, 1);
    border_sizes(&c->bins, 1);
}

#ifdef BORDER_INSIDE

static double distribution(double x)
{
    double below;
    border_ask(0);
    border_doubles(&x, 1);
    border_hear();
    border_doubles(&below, 1);
    return below;
}

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *edge = border_place_doubles("edge", c.bins + 1);
    equal_bins(distribution, c.low, c.high, c.bins, edge);
    border_reply();
    border_doubles(edge, c.bins + 1);
}

#else

static double (*law)(double x); /* of the call under way */

void border_heed(int which)
{
    double x, below;
    (void)which;
    border_doubles(&x, 1);
    below = law(x);
    border_tell();
    border_doubles(&below, 1);
}

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[])
{
    struct call c = {low, high, bins};
    law = distribution;
    border_call();
    move_arguments(&c);
    border_doubles(edge, bins + 1);
    border_wait();
    border_doubles(edge, bins + 1);
}

#endif
