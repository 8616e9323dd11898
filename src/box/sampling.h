/* Monte Carlo for hard disks: throws, a Markov chain, event chains. */
#ifndef SAMPLING_H
#define SAMPLING_H

#include "box/disks.h"
#include "toolbox/random.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { SAMPLING_IMAGES = 27 }; /* of a disk near a cell of a periodic box */

/* Hard disks or spheres of which only the places count: the large ones,
   from the first on, and behind them small ideal ones, which overlap with
   large ones and walls but not with each other. */
struct sampling {
    struct disks disks; /* all of them; nothing moves by itself */
    size_t large;
    double per_side[DISKS_AXES]; /* 1/m; 0 where there are walls */
    double (*blocked)[2]; /* room for blocked stretches of a line, m */
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
   overlaps, and returns how many fitted. If all did, the places are a
   sample of (6.1, eq:throw). */
size_t sampling_throw(struct sampling *s, struct random *r);

/* Returns an estimate, from this number of throws, of the natural logarithm
   of the fraction of throws in which all fit. Where none got far enough,
   the last fraction seen is taken for all the rest, which is too hopeful as
   long as disks do not overlap. */
double sampling_log_acceptance(struct sampling *s, uint64_t throws,
                               struct random *r);

/* Return what one configuration says of the density of large disk i at the
   two walls across axis k, 1/m, and of the density of distances at contact,
   1/m, from sliding i away from j (6.6, eq:slide): their means over a run
   are the densities. Require places at which all fit. */
double sampling_wall_density(const struct sampling *s, size_t i, size_t k);
double sampling_pair_density(const struct sampling *s, size_t i, size_t j);

/* Tries one move of a Markov chain, (6.7, eq:metropolis), of a disk drawn
   at random: a large one by up to +-step (m) along each axis, a small one
   to anywhere. Returns whether it moved; if not, the configuration counts
   again. Requires places at which all fit. */
bool sampling_try(struct sampling *s, double step, struct random *r);

/* Places the large ones on a lattice, or on a grid if they do not fit on
   it, and the small ones at random. Returns false if no start was found. */
bool sampling_start(struct sampling *s, struct random *r);

/* Pushes a large disk at random, and each that is touched after it, up
   along an axis, by a total of `length` (m): an event chain, which keeps
   (6.1, eq:throw) by (6.9, eq:global-balance). Returns how often the push
   was handed on; adds to *gained how far ahead, along the axis, the next
   disk then stood (m). Requires a periodic box, no small ones, and places
   at which all fit. */
uint64_t sampling_chain(struct sampling *s, size_t axis, double length,
                        struct random *r, double *gained);

/* Return the area (volume) that two disks (balls) of this radius with
   centres at this distance have in common, (6.14, eq:lens), (6.15,
   eq:lens3), and the part of one that lies behind a line (plane) at this
   distance from its centre. Require 2 or 3 dimensions, distance >= 0. */
double sampling_overlap(size_t dimensions, double radius, double distance);
double sampling_segment(size_t dimensions, double radius, double distance);

#endif
