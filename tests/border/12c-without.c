/* What crosses the border of exercise 12c: see examiner/border.h. */

#include "examiner/border.h"

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound);

/* The arguments, and the place for the bound as it is before. */
struct call {
    double push, stretch, time, budget, bound;
};

static void move_arguments(struct call *c)
{
    border_doubles(&c->push, 1);
    border_doubles(&c->stretch, 1);
    border_doubles(&c->time, 1);
    border_doubles(&c->budget, 1);
    border_doubles(&c->bound, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    bool may = leave_out(c.push, c.stretch, c.time, &c.budget, &c.bound);
    border_reply();
    border_bools(&may, 1);
    border_doubles(&c.budget, 1);
    border_doubles(&c.bound, 1);
}

#else

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound)
{
    struct call c = {push, stretch, time, *budget, *bound};
    bool may;
    border_call();
    move_arguments(&c);
    border_wait();
    border_bools(&may, 1);
    border_doubles(budget, 1);
    border_doubles(bound, 1);
    return may;
}

#endif
