/* What crosses the border of exercise 06d: see examiner/border.h. */
/* place: push_chain x n */

#include "examiner/border.h"
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
    border_sizes(&c->n, 1);
    border_sizes(&c->first, 1);
    border_doubles(&c->sigma, 1);
    border_doubles(&c->width, 1);
    border_doubles(&c->height, 1);
    border_doubles(&c->length, 1);
}

#ifdef BORDER_INSIDE

void border_answer(void)
{
    struct call c;
    move_arguments(&c);
    double *y = border_array(c.n, sizeof *y);
    border_doubles(y, c.n);
    double *x = border_place_doubles("x", c.n);
    size_t touches = push_chain(c.n, c.sigma, c.width, c.height, x, y,
                                c.first, c.length);
    border_reply();
    border_sizes(&touches, 1);
    border_doubles(x, c.n);
    free(y);
}

#else

size_t push_chain(size_t n, double sigma, double width, double height,
                  double x[], const double y[], size_t first, double length)
{
    struct call c = {n, first, sigma, width, height, length};
    size_t touches;
    border_call();
    move_arguments(&c);
    border_doubles((double *)y, n); /* which only reads on this side */
    border_doubles(x, n);
    border_wait();
    border_sizes(&touches, 1);
    border_doubles(x, n);
    return touches;
}

#endif
