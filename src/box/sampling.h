/* From chapters/06-room.nw: edit there, then run make tangle. */
/* checksum 1440019580 of the lines below */
/* Places of hard disks without motion: throws, a chain, their densities. */
#ifndef SAMPLING_H
#define SAMPLING_H

#include "box/disks.h"
#include "toolbox/random.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Hard disks or spheres of which only the places count: the large ones,
   from the first on, and behind them small ones that see the large ones
   and the walls but not each other. */
struct sampling {
    struct disks disks; /* all of them; nothing moves by itself */
    size_t large;
    double per_side[DISKS_AXES]; /* 1/m; 0 where there are walls */
    double (*blocked)[2]; /* room for the lines that disks slide on */
};

enum { SAMPLING_BLOCKS = 128 }; /* even; at least half of them are full */

/* Means of quantities over a run, with errors from blocks of samples that
   double in length when there are too many. Not yet the blocks of chapter
   7: those take whole samples, here a few of hundreds of bins change. */
struct sampling_means {
    size_t quantities, blocks; /* full ones */
    uint64_t length, filled;   /* samples in a full block, in the next */
    double *sum; /* of block b, quantity q: b quantities + q */
};

/* Prepares a box of this boundary and these sides (m, as many as
   dimensions) for `large` disks or spheres of one radius (m) and `small`
   ideal ones of another; places none. Returns false, with nothing to
   free, when there is no memory. */
bool sampling_create(struct sampling *s, size_t dimensions,
                     enum disks_boundary boundary, const double box[],
                     size_t large, double radius, size_t small,
                     double small_radius);
void sampling_free(struct sampling *s);

/* Throws one after the other anywhere into the box, up to the first that
   overlaps, and returns how many fitted. When that is all, the places are
   a sample of (6.1, eq:throw). */
size_t sampling_throw(struct sampling *s, struct random *r);

/* Returns the natural logarithm of the share of throws in which all will
   fit, from this many throws. Where none got far enough, the last share
   seen is taken for all the rest, which is too hopeful as long as disks
   see each other. */
double sampling_log_acceptance(struct sampling *s, uint64_t throws,
                               struct random *r);

/* The density (1/m) of large disk i at the two walls across axis k, and
   that of the distances of large disks at contact, from sliding i away
   from j: (6.6, eq:slide). Means over a run have to be taken. Require
   places at which all fit. */
double sampling_wall_density(const struct sampling *s, size_t i, size_t k);
double sampling_pair_density(const struct sampling *s, size_t i, size_t j);

/* Tries one move of a Markov chain, (6.7, eq:metropolis): one at random,
   a large one by up to +-step (m) along each axis, a small one to
   anywhere. Returns whether it moved; if not, where it is counts again.
   Requires places at which all fit. */
bool sampling_try(struct sampling *s, double step, struct random *r);

/* Places the large ones on a lattice, or on a grid if they do not fit on
   it, and the small ones at random. Returns false if no start was found. */
bool sampling_start(struct sampling *s, struct random *r);

/* Empties m. Returns false without memory. */
bool sampling_means_create(struct sampling_means *m, size_t quantities);
void sampling_means_free(struct sampling_means *m);

/* Adds to a quantity of the sample that is being taken; ends the sample. */
void sampling_means_add(struct sampling_means *m, size_t quantity,
                        double value);
void sampling_means_next(struct sampling_means *m);

/* The mean over all samples, NAN if there are none, and its standard error
   from the full blocks, NAN for fewer than two. */
double sampling_means_mean(const struct sampling_means *m, size_t quantity);
double sampling_means_error(const struct sampling_means *m,
                            size_t quantity);

/* Pushes a large disk at random, and each that is touched after it, up
   along an axis, by a total of `length` (m): an event chain, which keeps
   (6.1, eq:throw) by (6.9, eq:global-balance). Returns how often the push
   was handed on; adds to *gained how far ahead, along the axis, the next
   disk then stood (m). Requires a periodic box, no small ones, and places
   at which all fit. */
uint64_t sampling_chain(struct sampling *s, size_t axis, double length,
                        struct random *r, double *gained);

/* The area (volume) that two disks (balls) of this radius have in common
   when their centres are so far apart, (6.14, eq:lens), (6.15, eq:lens3),
   and the part of one that lies behind a line (plane) at this distance
   from its centre. Requires 2 or 3 dimensions, apart and distance >= 0. */
double sampling_overlap(size_t dimensions, double radius, double apart);
double sampling_segment(size_t dimensions, double radius, double distance);

#endif
