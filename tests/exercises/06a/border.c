/* What crosses the border of exercise 06a: see examiner/border.h. The
   random numbers stay outside and come in by the BLOCK; with the answer it
   is said how many of the last block were left over, and only what was used
   is used up in the suite. */
/* place: throw_disks x n */
/* place: throw_disks y n */

#include "examiner/border.h"
#include <stdlib.h>
#include <string.h>

double uniform(void);
size_t throw_disks(size_t n, const double radius[], double width,
                   double height, double x[], double y[]);

/* Outside, in the suite: the numbers that uniform() will give next. */
void uniform_ahead(double u[], size_t count);

enum { MORE, BLOCK = 64 };

#ifdef BORDER_INSIDE

static struct {
    double u[BLOCK];
    size_t left;
} block;

static void take_block(void)
{
    border_doubles(block.u, BLOCK);
    block.left = BLOCK;
}

double uniform(void)
{
    if (block.left == 0) {
        border_ask(MORE);
        border_hear();
        take_block();
    }
    return block.u[BLOCK - block.left--];
}

void border_answer(void)
{
    size_t n, throws;
    double size[2];
    border_sizes(&n, 1);
    border_doubles(size, 2);
    double *radius = border_memory(n * sizeof *radius);
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

static void give_block(void)
{
    double u[BLOCK];
    uniform_ahead(u, BLOCK);
    border_doubles(u, BLOCK);
}

static void use_up(size_t left)
{
    for (size_t k = left; k < BLOCK; ++k)
        (void)uniform();
}

/* All of the last block are used: more. */
void border_heed(int which)
{
    (void)which;
    use_up(0);
    border_tell();
    give_block();
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
