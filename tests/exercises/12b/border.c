/* What crosses the border of exercise 12b: see examiner/border.h. */
/* place: choose_step step 1 */

#include "examiner/border.h"

enum verdict { OUT_OF_REACH, TOO_FINE, NO_ORDER, CHOSEN };

enum verdict choose_step(double p, const double h[2], const double error[2],
                         double rounding, double tolerance, double *step);

/* The arguments; the step follows. */
struct call {
    double p, h[2], error[2], rounding, tolerance;
};

static void move_arguments(struct call *c)
{
    border_doubles(&c->p, 1);
    border_doubles(c->h, 2);
    border_doubles(c->error, 2);
    border_doubles(&c->rounding, 1);
    border_doubles(&c->tolerance, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    const double h[2] = {c.h[0], c.h[1]};
    const double error[2] = {c.error[0], c.error[1]};
    double *step = border_place_doubles("step", 1);
    int verdict =
        (int)choose_step(c.p, h, error, c.rounding, c.tolerance, step);
    border_reply();
    border_ints(&verdict, 1);
    border_doubles(step, 1);
}

#else

enum verdict choose_step(double p, const double h[2], const double error[2],
                         double rounding, double tolerance, double *step)
{
    struct call c = {
        p, {h[0], h[1]}, {error[0], error[1]}, rounding, tolerance};
    int verdict;
    border_call();
    move_arguments(&c);
    border_doubles(step, 1);
    border_wait();
    border_ints(&verdict, 1);
    border_doubles(step, 1);
    return (enum verdict)verdict;
}

#endif
