/* What crosses the border of exercise 06b: see examiner/border.h. The
   random numbers stay outside, and each of them is asked for. */

#include "examiner/border.h"
#include <stdlib.h>

double uniform(void);
double mean_square(size_t n, double radius, double dish, double step,
                   size_t tries, double x[], double y[], size_t *accepted);

enum { UNIFORM };

/* The arguments but for the two lists, and *accepted as it is before. */
struct call {
    size_t n, tries, accepted;
    double radius, dish, step;
};

static void move_arguments(struct call *c)
{
    border_sizes(&c->n, 1);
    border_sizes(&c->tries, 1);
    border_sizes(&c->accepted, 1);
    border_doubles(&c->radius, 1);
    border_doubles(&c->dish, 1);
    border_doubles(&c->step, 1);
}

#ifdef BORDER_INSIDE

double uniform(void)
{
    double u;
    border_ask(UNIFORM);
    border_hear();
    border_doubles(&u, 1);
    return u;
}

static double *take_doubles(size_t n)
{
    double *x = border_memory(n * sizeof *x);
    border_doubles(x, n);
    return x;
}

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *x = take_doubles(c.n), *y = take_doubles(c.n);
    double mean = mean_square(c.n, c.radius, c.dish, c.step, c.tries, x, y,
                              &c.accepted);
    border_reply();
    border_doubles(&mean, 1);
    border_sizes(&c.accepted, 1);
    border_doubles(x, c.n);
    border_doubles(y, c.n);
    free(x);
    free(y);
}

#else

void border_heed(int which)
{
    (void)which;
    double u = uniform();
    border_tell();
    border_doubles(&u, 1);
}

double mean_square(size_t n, double radius, double dish, double step,
                   size_t tries, double x[], double y[], size_t *accepted)
{
    struct call c = {n, tries, *accepted, radius, dish, step};
    double mean;
    border_call();
    move_arguments(&c);
    border_doubles(x, n);
    border_doubles(y, n);
    border_wait();
    border_doubles(&mean, 1);
    border_sizes(accepted, 1);
    border_doubles(x, n);
    border_doubles(y, n);
    return mean;
}

#endif
