/* Computes means over time from blocks of samples that grow in length. */
#include "box/blocks.h"

#include "line/statistics.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool blocks_create(struct blocks *b, size_t width)
{
    *b = (struct blocks){.width = width, .per = 1};
    b->sum = calloc(BLOCKS_MOST * width, sizeof b->sum[0]);
    return b->sum != NULL;
}

void blocks_free(struct blocks *b)
{
    free(b->sum);
    *b = (struct blocks){0};
}
/* Ends the current block. When all blocks are full, adds neighbours in
   pairs, which empties the second half of the blocks. */
static void end_block(struct blocks *b)
{
    const size_t width = b->width, half = BLOCKS_MOST / 2;
    b->filled = 0;
    if (++b->count < BLOCKS_MOST)
        return;
    for (size_t i = 0; i < half; ++i)
        for (size_t k = 0; k < width; ++k)
            b->sum[i * width + k] =
                b->sum[2 * i * width + k] + b->sum[(2 * i + 1) * width + k];
    memset(b->sum + half * width, 0, half * width * sizeof b->sum[0]);
    b->count = half;
    b->per *= 2;
}

void blocks_add(struct blocks *b, const double sample[])
{
    double *sum = b->sum + b->count * b->width;
    for (size_t k = 0; k < b->width; ++k)
        sum[k] += sample[k];
    if (++b->filled == b->per)
        end_block(b);
}

void blocks_append(struct blocks *b, const double sum[])
{
    memcpy(b->sum + b->count * b->width, sum, b->width * sizeof sum[0]);
    end_block(b);
}

enum { PARTS = 16 }; /* number of equal parts of each third of the values */

struct third {
    double mean, square; /* square: of the standard error of the mean */
};

/* Returns the mean of a third of the values and the square of its standard
   error, from the scatter of 16 parts. Both are in units of `unit`, since
   squares of large numbers could overflow. The square is NAN if the scatter
   does not measure an error: if a part has only zeros because events are
   rare, or if all parts are equal, as when a single disk bounces
   regularly. */
static struct third third_of(double unit, const double x[], size_t per)
{
    double part[PARTS] = {0};
    bool idle = false;
    for (size_t i = 0; i < PARTS * per; ++i)
        part[i / per] += x[i] / unit / (double)per;
    for (size_t i = 0; i < PARTS; ++i)
        idle = idle || part[i] == 0;
    const struct statistics_moments m = statistics_moments(PARTS, part);
    idle = idle || !(sqrt(m.variance) > 1e-9 * fabs(m.mean));
    return (struct third){m.mean, idle ? NAN : m.variance / PARTS};
}

/* Returns the number of standard errors by which the last third exceeds the
   first, or NAN if this is unknown. Uses the smaller of the errors of the
   two thirds. In a steady run both estimate the same error. If a crystal
   melts during one third, the larger error would hide the drift. */
static double drift_of(size_t n, const double x[])
{
    const size_t per = n / 3 / PARTS;
    if (per == 0)
        return NAN;
    const double unit = statistics_unit(n, x);
    const struct third a = third_of(unit, x, per);
    const struct third b = third_of(unit, x + n - PARTS * per, per);
    if (isnan(a.square + b.square))
        return NAN;
    return (b.mean - a.mean) /
           sqrt(2 * fmin(a.square, b.square)); /* (7.18, eq:drift) */
}

/* The error is found by blocking the values, as in chapter 3. */
struct blocks_average blocks_average_of(size_t n, const double x[])
{
    struct statistics_blocking b;
    const double unit = statistics_unit(n, x);
    double sum = 0;
    for (size_t i = 0; i < n; ++i)
        sum += x[i] / unit;
    const bool known = n >= 2 && statistics_blocking(n, x, &b);
    return (struct blocks_average){sum / (double)n * unit,
                                   known ? b.error : NAN, drift_of(n, x)};
}

struct blocks_average blocks_average(const struct blocks *b, size_t column)
{
    double x[BLOCKS_MOST];
    for (size_t i = 0; i < b->count; ++i)
        x[i] = b->sum[i * b->width + column] / (double)b->per;
    return blocks_average_of(b->count, x);
}
