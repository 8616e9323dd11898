/* Computes means over time and their errors, from samples in blocks. */
#ifndef BLOCKS_H
#define BLOCKS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { BLOCKS_MOST = 512 }; /* capacity; at most 511 blocks are full */

/* Sums of samples of `width` numbers each, with `per` samples in a block.
   The members may be read. The sums of block i begin at sum[i * width]. The
   row after the full blocks belongs to the unfinished block, which is not
   used for means and errors. */
struct blocks {
    size_t width, count;  /* count: number of full blocks */
    uint64_t per, filled; /* filled: samples in the unfinished block */
    double *sum;
};

/* Prepares *b without samples. Returns false, with nothing to free, if
   memory runs out. */
bool blocks_create(struct blocks *b, size_t width);
void blocks_free(struct blocks *b);

/* Adds a sample to the unfinished block. */
void blocks_add(struct blocks *b, const double sample[]);

/* Adds a full block: the sum of `per` samples. A caller must use either
   this function or blocks_add, but not both. */
void blocks_append(struct blocks *b, const double sum[]);

/* A mean and its standard error, which is NAN for fewer than 2 values.
   drift is the difference between the means of the last and the first third
   of the values, divided by the standard error of this difference (7.18,
   eq:drift). It is NAN for fewer than 48 values, if one of the 16 parts of
   a third has only zeros, or if all parts of a third are equal up to
   rounding. */
struct blocks_average {
    double mean, error, drift;
};

enum { BLOCKS_STEADY = 6 }; /* largest |drift| that chance can explain */

/* Return the average of a column of the samples, and the average of n
   values in the order of measurement. */
struct blocks_average blocks_average(const struct blocks *b, size_t column);
struct blocks_average blocks_average_of(size_t n, const double x[]);

#endif
