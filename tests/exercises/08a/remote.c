/* The remote calls of exercise 08a: see examiner/remote.h. The
   forces stay outside and are asked for. With the coordinates and the
   velocities comes the place behind them: the suite has put something
   there. */
/* output: drift_kick_drift x n suite */
/* output: drift_kick_drift v n suite */

#include "examiner/remote.h"

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
    remote_sizes(&c->n, 1);
    remote_sizes(&c->steps, 1);
    remote_doubles(&c->dt, 1);
}

/* How many coordinates the call that is under way has. */
static size_t present;

#ifdef REMOTE_SERVER

void acceleration(const double x[], double a[])
{
    double copy[MOST];
    for (size_t i = 0; i < present; ++i)
        copy[i] = x[i];
    remote_callback(0);
    remote_doubles(copy, present);
    remote_callback_wait();
    remote_doubles(a, present);
}

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    double *x = remote_output_doubles("x", c.n + 1);
    double *v = remote_output_doubles("v", c.n + 1);
    present = c.n;
    drift_kick_drift(c.n, x, v, c.dt, c.steps);
    remote_reply();
    remote_doubles(x, c.n + 1);
    remote_doubles(v, c.n + 1);
}

#else

void remote_serve_callback(int which)
{
    double x[MOST], a[MOST];
    (void)which;
    remote_doubles(x, present);
    acceleration(x, a);
    remote_callback_reply();
    remote_doubles(a, present);
}

void drift_kick_drift(size_t n, double x[], double v[], double dt,
                      size_t steps)
{
    struct call c = {n, steps, dt};
    present = n;
    remote_call();
    move_arguments(&c);
    remote_doubles(x, n + 1);
    remote_doubles(v, n + 1);
    remote_wait();
    remote_doubles(x, n + 1);
    remote_doubles(v, n + 1);
}

#endif
