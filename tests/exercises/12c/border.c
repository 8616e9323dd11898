/* What crosses the border of exercise 12c: see examiner/border.h. */
/* place: leave_out budget 1 */
/* place: leave_out bound 1 */

#include "examiner/border.h"

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound);

/* The arguments; the budget and the bound follow. */
struct call {
    double push, stretch, time;
};

static void move_arguments(struct call *c)
{
    border_doubles(&c->push, 1);
    border_doubles(&c->stretch, 1);
    border_doubles(&c->time, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *budget = border_place_doubles("budget", 1);
    double *bound = border_place_doubles("bound", 1);
    bool may = leave_out(c.push, c.stretch, c.time, budget, bound);
    border_reply();
    border_bools(&may, 1);
    border_doubles(budget, 1);
    border_doubles(bound, 1);
}

#else

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound)
{
    struct call c = {push, stretch, time};
    bool may;
    border_call();
    move_arguments(&c);
    border_doubles(budget, 1);
    border_doubles(bound, 1);
    border_wait();
    border_bools(&may, 1);
    border_doubles(budget, 1);
    border_doubles(bound, 1);
    return may;
}

#endif
