/* Means over time with honest errors, from samples summed in blocks. */
#ifndef BLOCKS_H
#define BLOCKS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { BLOCKS_MOST = 512 }; /* capacity: one more than can be full */

/* Sums of samples of `width` numbers, `per` samples to a block. To be
   read: the sums of block i begin at sum[i * width]; the row behind the
   full blocks is the one that is being filled, which counts neither for a
   mean nor for its error. */
struct blocks {
    size_t width, count;  /* full blocks */
    uint64_t per, filled; /* samples in the block that is not yet full */
    double *sum;
};

/* Returns false, with nothing to free, when there is no memory. */
bool blocks_create(struct blocks *b, size_t width);
void blocks_free(struct blocks *b);

/* Adds a sample to the present block. */
void blocks_add(struct blocks *b, const double sample[]);

/* Adds a whole block at once, `per` samples that the caller has summed.
   Not to be mixed with blocks_add. */
void blocks_append(struct blocks *b, const double sum[]);

/* A mean and its standard error, NAN for fewer than 2 values; and by how
   many of its errors the mean of the last third of the values exceeds that
   of the first (7.18, eq:drift), NAN for fewer than 48 values, if a 16th
   part of a third has only zeros, or if all parts of one are alike but for
   rounding. */
struct blocks_average {
    double mean, error, drift;
};

enum { BLOCKS_STEADY = 6 }; /* the largest drift that chance explains */

/* The average of a column of the samples, and of n values in order. */
struct blocks_average blocks_average(const struct blocks *b, size_t column);
struct blocks_average blocks_average_of(size_t n, const double x[]);

#endif
