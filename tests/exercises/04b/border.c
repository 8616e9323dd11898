/* What crosses the border of exercise 04b: see examiner/border.h. */
/* place: decay_time tau 1 */
/* place: decay_time sigma 1 */

#include "examiner/border.h"
#include <stdlib.h>

bool decay_time(size_t n, const double t[], const double share[],
                const double error[], double limit, double *tau,
                double *sigma);

/* The numbers among the arguments; the points and the two places follow. */
struct call {
    size_t n;
    double limit;
};

static void move_arguments(struct call *c)
{
    border_sizes(&c->n, 1);
    border_doubles(&c->limit, 1);
}

static void move_answer(bool *told, double *tau, double *sigma)
{
    border_bools(told, 1);
    border_doubles(tau, 1);
    border_doubles(sigma, 1);
}

#ifdef BORDER_INSIDE

static double *take(size_t n)
{
    double *x = border_memory(n * sizeof *x);
    border_doubles(x, n);
    return x;
}

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *t = take(c.n), *share = take(c.n), *error = take(c.n);
    double *tau = border_place_doubles("tau", 1);
    double *sigma = border_place_doubles("sigma", 1);
    bool told = decay_time(c.n, t, share, error, c.limit, tau, sigma);
    border_reply();
    move_answer(&told, tau, sigma);
    free(t);
    free(share);
    free(error);
}

#else

static void give(const double x[], size_t n)
{
    border_doubles((double *)x, n); /* which only reads on this side */
}

bool decay_time(size_t n, const double t[], const double share[],
                const double error[], double limit, double *tau,
                double *sigma)
{
    struct call c = {n, limit};
    bool told;
    border_call();
    move_arguments(&c);
    give(t, n);
    give(share, n);
    give(error, n);
    border_doubles(tau, 1);
    border_doubles(sigma, 1);
    border_wait();
    move_answer(&told, tau, sigma);
    return told;
}

#endif
