/* What crosses the border of exercise 08a: see examiner/border.h. The
   forces stay outside and are asked for. With the coordinates and the
   velocities comes the place behind them: the suite has put something
   there. */
/* place: drift_kick_drift x n suite */
/* place: drift_kick_drift v n suite */

#include "examiner/border.h"

void acceleration(const double x[], double a[]);
void drift_kick_drift(size_t n, double x[], double v[], double dt,
                      size_t steps);

enum { MOST = 60 };

/* The arguments but for the arrays. */
struct call {
    size_t n, steps;
    double dt;
};

static void move_arguments(struct call *c)
{
    border_sizes(&c->n, 1);
    border_sizes(&c->steps, 1);
    border_doubles(&c->dt, 1);
}

/* How many coordinates the call that is under way has. */
static size_t present;

#ifdef BORDER_INSIDE

void acceleration(const double x[], double a[])
{
    double copy[MOST];
    for (size_t i = 0; i < present; ++i)
        copy[i] = x[i];
    border_ask(0);
    border_doubles(copy, present);
    border_hear();
    border_doubles(a, present);
}

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *x = border_place_doubles("x", c.n + 1);
    double *v = border_place_doubles("v", c.n + 1);
    present = c.n;
    drift_kick_drift(c.n, x, v, c.dt, c.steps);
    border_reply();
    border_doubles(x, c.n + 1);
    border_doubles(v, c.n + 1);
}

#else

void border_heed(int which)
{
    double x[MOST], a[MOST];
    (void)which;
    border_doubles(x, present);
    acceleration(x, a);
    border_tell();
    border_doubles(a, present);
}

void drift_kick_drift(size_t n, double x[], double v[], double dt,
                      size_t steps)
{
    struct call c = {n, steps, dt};
    present = n;
    border_call();
    move_arguments(&c);
    border_doubles(x, n + 1);
    border_doubles(v, n + 1);
    border_wait();
    border_doubles(x, n + 1);
    border_doubles(v, n + 1);
}

#endif
