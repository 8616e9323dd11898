/* What crosses the border of exercise 06a: see examiner/border.h. The
   random numbers stay outside, and each of them is asked for. */

#include "examiner/border.h"
#include <stdlib.h>
#include <string.h>

double uniform(void);
size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[]);

enum { UNIFORM };

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
    size_t n, throws;
    double size[2];
    border_sizes(&n, 1);
    border_doubles(size, 2);
    double *radius = take_doubles(n);
    double *x = take_doubles(n), *y = take_doubles(n);
    throws = throw_disks(n, radius, size[0], size[1], x, y);
    border_reply();
    border_sizes(&throws, 1);
    border_doubles(x, n);
    border_doubles(y, n);
    free(radius);
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

static void give_doubles(const double x[], size_t n)
{
    double *copy = border_memory(n * sizeof *copy);
    memcpy(copy, x, n * sizeof *copy);
    border_doubles(copy, n);
    free(copy);
}

size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[])
{
    size_t throws;
    double size[2] = {width, height};
    border_call();
    border_sizes(&n, 1);
    border_doubles(size, 2);
    give_doubles(radius, n);
    border_doubles(x, n);
    border_doubles(y, n);
    border_wait();
    border_sizes(&throws, 1);
    border_doubles(x, n);
    border_doubles(y, n);
    return throws;
}

#endif
