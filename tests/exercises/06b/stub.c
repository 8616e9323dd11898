/* Exercise 06b. A chain that forgets its rejections (core, 25 minutes)

   Equal disks lie in a round dish. A Markov chain shakes them: each try
   takes one disk by chance and moves it a little, unless it would then
   reach out of the dish or overlap another disk. How far from the middle
   are the disks on the average? The chain below moves them rightly, but the
   average that it returns is wrong. Mend it.

   Given:
     n          the number of disks, from 1 to 100
     radius     of each disk, in m
     dish       the radius of the dish, in m; its middle is (0, 0)
     step       a move changes x and y by up to so much, in m
     tries      how often a move is tried, at least 1
     x, y       the centres at the start, in m: an allowed placing
   To fill in:
     x, y       the centres after the last try
     *accepted  how many of the moves took place
   Returns the average of x^2 + y^2, in m^2: over all disks, and over the
   placings that the chain is in after the first try, the second, and so on
   to the last.

   All that is random comes from uniform(), which the check provides: a
   number from 0 to below 1. A try asks for three of them, whatever comes of
   it: for the disk, for its move in x and for its move in y.

   Check your answer with    make check EX=06b
   Hints, which ask before they tell:    make hint EX=06b */

#include "exercise.h"
#include <stdbool.h>
#include <stddef.h>

double uniform(void);

/* Says whether disk i might lie at (a, b) while the others stay. */
static bool allowed(size_t n, double radius, double dish, const double x[],
                    const double y[], size_t i, double a, double b)
{
    const double room = dish - radius, reach = 2.0 * radius;
    bool free = a * a + b * b <= room * room;
    for (size_t k = 0; k < n && free; ++k) {
        const double dx = a - x[k], dy = b - y[k];
        free = k == i || dx * dx + dy * dy >= reach * reach;
    }
    return free;
}

/* The sum of x^2 + y^2 over all disks. */
static double squares(size_t n, const double x[], const double y[])
{
    double sum = 0.0;
    for (size_t k = n; k-- > 0;)
        sum += x[k] * x[k] + y[k] * y[k];
    return sum;
}

double mean_square(size_t n, double radius, double dish, double step,
                   size_t tries, double x[], double y[], size_t *accepted)
{
    /* TODO: mend these lines. The chain goes where it should. But how long
       does it stay in each of its placings? */
    double sum = NOT_DONE_YET(0.0);
    *accepted = 0;
    for (size_t t = 1; t <= tries; ++t) {
        const size_t i = (size_t)((double)n * uniform());
        const double a = x[i] + step * (2.0 * uniform() - 1.0);
        const double b = y[i] + step * (2.0 * uniform() - 1.0);
        if (!allowed(n, radius, dish, x, y, i, a, b))
            continue;
        x[i] = a;
        y[i] = b;
        ++*accepted;
        sum += squares(n, x, y);
    }
    return sum / ((double)n * (double)*accepted);
}
