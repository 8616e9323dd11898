/* The remote calls of exercise 12c: see examiner/remote.h. */
/* output: leave_out budget 1 */
/* output: leave_out bound 1 */

#include "examiner/remote.h"

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound);

/* The arguments; the budget and the bound follow. */
struct call {
    double push, stretch, time;
};

static void move_arguments(struct call *c)
{
    remote_doubles(&c->push, 1);
    remote_doubles(&c->stretch, 1);
    remote_doubles(&c->time, 1);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    double *budget = remote_output_doubles("budget", 1);
    double *bound = remote_output_doubles("bound", 1);
    bool may = leave_out(c.push, c.stretch, c.time, budget, bound);
    remote_reply();
    remote_bools(&may, 1);
    remote_doubles(budget, 1);
    remote_doubles(bound, 1);
}

#else

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound)
{
    struct call c = {push, stretch, time};
    bool may;
    remote_call();
    move_arguments(&c);
    remote_doubles(budget, 1);
    remote_doubles(bound, 1);
    remote_wait();
    remote_bools(&may, 1);
    remote_doubles(budget, 1);
    remote_doubles(bound, 1);
    return may;
}

#endif
