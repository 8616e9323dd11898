/* Means over a run with errors from blocks that double in length. */
#ifndef MEANS_H
#define MEANS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MEANS_BLOCKS = 128 }; /* even; a long run fills at least half */

/* Sums of quantities over blocks of samples. When all blocks are full,
   neighbours are joined, and from then on a block is twice as long: an
   error comes from 64 to 127 blocks however long the run, and is itself
   uncertain by 6 to 9 %. (box/blocks.h adds whole samples; here a sample
   changes a few of hundreds of bins.) */
struct means {
    size_t quantities, blocks; /* blocks: number of full ones */
    uint64_t length, filled;   /* samples in a full block, in the next */
    double *sum; /* sum[b * quantities + q]: block b, quantity q */
};

/* Prepares *m without samples. Returns false if memory runs out. */
bool means_create(struct means *m, size_t quantities);
void means_free(struct means *m);

/* Adds a value to a quantity of the present sample; ends this sample. */
void means_add(struct means *m, size_t quantity, double value);
void means_next(struct means *m);

/* Return the mean over all samples, NAN if there are none, and its standard
   error from the full blocks, NAN for fewer than two. */
double means_mean(const struct means *m, size_t quantity);
double means_error(const struct means *m, size_t quantity);

#endif
