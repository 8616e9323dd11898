/* The remote calls of exercise 06d: see examiner/remote.h. */
/* output: push_chain x n */

#include "examiner/remote.h"
#include <stdlib.h>

size_t push_chain(size_t n, double sigma, double width, double height,
                  double x[], const double y[], size_t first,
                  double length);

struct call {
    size_t n, first;
    double sigma, width, height, length;
};

static void move_arguments(struct call *c)
{
    remote_sizes(&c->n, 1);
    remote_sizes(&c->first, 1);
    remote_doubles(&c->sigma, 1);
    remote_doubles(&c->width, 1);
    remote_doubles(&c->height, 1);
    remote_doubles(&c->length, 1);
}

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    struct call c;
    move_arguments(&c);
    double *y = remote_array(c.n, sizeof *y);
    remote_doubles(y, c.n);
    double *x = remote_output_doubles("x", c.n);
    size_t touches = push_chain(c.n, c.sigma, c.width, c.height, x, y,
                                c.first, c.length);
    remote_reply();
    remote_sizes(&touches, 1);
    remote_doubles(x, c.n);
    free(y);
}

#else

size_t push_chain(size_t n, double sigma, double width, double height,
                  double x[], const double y[], size_t first, double length)
{
    struct call c = {n, first, sigma, width, height, length};
    size_t touches;
    remote_call();
    move_arguments(&c);
    remote_doubles((double *)y, n); /* which only reads on this side */
    remote_doubles(x, n);
    remote_wait();
    remote_sizes(&touches, 1);
    remote_doubles(x, n);
    return touches;
}

#endif
