/* The remote calls of exercise 06a: see examiner/remote.h, and for
   the random numbers examiner/remote_random.h. */
/* output: throw_disks x n */
/* output: throw_disks y n */

#include "examiner/remote_random.h"
#include <stdlib.h>
#include <string.h>

size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[]);

/* Of the suite; here, too, so that src/examiner/check.mk finds them. */
double uniform(void);
void uniform_ahead(double u[], size_t count);

#ifdef REMOTE_SERVER

void remote_serve(void)
{
    size_t n, throws;
    double size[2];
    remote_sizes(&n, 1);
    remote_doubles(size, 2);
    double *radius = remote_array(n, sizeof *radius);
    remote_doubles(radius, n);
    double *x = remote_output_doubles("x", n);
    double *y = remote_output_doubles("y", n);
    take_block();
    throws = throw_disks(n, radius, size[0], size[1], x, y);
    remote_reply();
    remote_sizes(&throws, 1);
    remote_sizes(&block.left, 1);
    remote_doubles(x, n);
    remote_doubles(y, n);
    free(radius);
}

#else

static void give_doubles(const double x[], size_t n)
{
    double *copy = remote_array(n, sizeof *copy);
    memcpy(copy, x, n * sizeof *copy);
    remote_doubles(copy, n);
    free(copy);
}

size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[])
{
    size_t throws, left;
    double size[2] = {width, height};
    remote_call();
    remote_sizes(&n, 1);
    remote_doubles(size, 2);
    give_doubles(radius, n);
    remote_doubles(x, n);
    remote_doubles(y, n);
    give_block();
    remote_wait();
    remote_sizes(&throws, 1);
    remote_sizes(&left, 1);
    remote_doubles(x, n);
    remote_doubles(y, n);
    use_up(left);
    return throws;
}

#endif
