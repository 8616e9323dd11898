/* Computes means over a run and their errors from blocks of samples. */
#ifndef MEANS_H
#define MEANS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MEANS_BLOCKS = 128 }; /* even; a long run fills at least half */

/* Sums of quantities over blocks of samples. When all blocks are full,
   neighbours are joined, and each block is then twice as long. So an error
   is computed from 64 to 127 blocks, however long the run, and its own
   uncertainty is 6 to 9 %. (Unlike box/blocks.h, which adds all quantities
   of a sample, this updates only the few bins that a sample changes.) */
struct means {
    size_t quantities, blocks; /* blocks: number of full blocks */
    uint64_t length, filled;   /* samples in a full block; samples in the
                                  next block */
    double *sum; /* sum[b * quantities + q]: block b, quantity q */
};

/* Prepares *m without samples. Returns false if memory runs out. */
bool means_create(struct means *m, size_t quantities);
void means_free(struct means *m);

/* Add a value to a quantity of the present sample, and end this sample. */
void means_add(struct means *m, size_t quantity, double value);
void means_next(struct means *m);

/* Return the mean over all samples, or NAN if there are none, and its
   standard error from the full blocks, or NAN for fewer than two blocks. */
double means_mean(const struct means *m, size_t quantity);
double means_error(const struct means *m, size_t quantity);

#endif
