/* What crosses the border of exercise 06a: see examiner/border.h, and for
   the random numbers examiner/supply.h. */
/* place: throw_disks x n */
/* place: throw_disks y n */

#include "examiner/supply.h"
#include <stdlib.h>
#include <string.h>

size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[]);

/* Of the suite; here, too, so that src/examiner/check.mk finds them. */
double uniform(void);
void uniform_ahead(double u[], size_t count);

#ifdef BORDER_INSIDE

void border_answer(void)
{
    size_t n, throws;
    double size[2];
    border_sizes(&n, 1);
    border_doubles(size, 2);
    double *radius = border_array(n, sizeof *radius);
    border_doubles(radius, n);
    double *x = border_place_doubles("x", n);
    double *y = border_place_doubles("y", n);
    take_block();
    throws = throw_disks(n, radius, size[0], size[1], x, y);
    border_reply();
    border_sizes(&throws, 1);
    border_sizes(&block.left, 1);
    border_doubles(x, n);
    border_doubles(y, n);
    free(radius);
}

#else

static void give_doubles(const double x[], size_t n)
{
    double *copy = border_array(n, sizeof *copy);
    memcpy(copy, x, n * sizeof *copy);
    border_doubles(copy, n);
    free(copy);
}

size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[])
{
    size_t throws, left;
    double size[2] = {width, height};
    border_call();
    border_sizes(&n, 1);
    border_doubles(size, 2);
    give_doubles(radius, n);
    border_doubles(x, n);
    border_doubles(y, n);
    give_block();
    border_wait();
    border_sizes(&throws, 1);
    border_sizes(&left, 1);
    border_doubles(x, n);
    border_doubles(y, n);
    use_up(left);
    return throws;
}

#endif
