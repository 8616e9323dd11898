/* Monte Carlo for hard disks: direct, by Markov chain, by event chains. */
#ifndef SAMPLING_H
#define SAMPLING_H

#include "box/disks.h"
#include "toolbox/random.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { SAMPLING_IMAGES = 27 }; /* images of a disk that may reach a cell */

/* Hard disks or spheres without motion: first the large ones, then small
   ideal ones, which must not overlap large ones or walls but may overlap
   each other. */
struct sampling {
    struct disks disks; /* all of them; velocities are not used */
    size_t large;
    double per_side[DISKS_AXES]; /* 1/box, 1/m; 0 where there are walls */
    double (*blocked)[2]; /* scratch: blocked intervals of a line, m */
};

/* Prepares a box with this boundary and these sides (m, one for each
   dimension) for `large` disks or spheres of one radius (m) and `small`
   ideal ones of another; places none. Returns false, with nothing to free,
   if memory runs out. */
bool sampling_create(struct sampling *s, size_t dimensions,
                     enum disks_boundary boundary, const double box[],
                     size_t large, double radius, size_t small,
                     double small_radius);
void sampling_free(struct sampling *s);

/* Places the disks one after another at random, up to the first that
   overlaps, and returns how many fitted. If all did, their positions are a
   sample of (6.1, eq:throw). */
size_t sampling_throw(struct sampling *s, struct random *r);

/* Returns an estimate, from this number of throws, of the natural logarithm
   of the fraction of throws in which all disks fit. Disks that fewer than
   ten throws reached get the fraction of the last disk before them, which
   overestimates the result at low densities. */
double sampling_log_acceptance(struct sampling *s, uint64_t throws,
                               struct random *r);

/* Return estimates from one configuration of the density of large disk i at
   the two walls across axis k, 1/m, and of the density of pair distances at
   contact, 1/m, from sliding i away from j (6.6, eq:slide). Their means
   over a run are the densities. Require places without overlaps. */
double sampling_wall_density(const struct sampling *s, size_t i, size_t k);
double sampling_pair_density(const struct sampling *s, size_t i, size_t j);

/* Tries one move of a Markov chain, (6.7, eq:metropolis), of a random disk:
   a large one by up to +-step (m) along each axis, a small one to any
   place. Returns whether it moved; if not, the old configuration counts
   again. Requires places without overlaps. */
bool sampling_try(struct sampling *s, double step, struct random *r);

/* Places the large ones on a close-packed lattice, or else on a grid, and
   the small ones at random. Returns false if they do not fit. */
bool sampling_start(struct sampling *s, struct random *r);

/* Moves a random large disk up along an axis until it touches another one,
   then that one, and so on, by a total of `length` (m): an event chain,
   which keeps (6.1, eq:throw) by (6.9, eq:global-balance). Returns the
   number of contacts; adds to *gained, for each, the distance along the
   axis from the disk to the one that it touched (m). Requires a periodic
   box, no small disks, and places without overlaps. */
uint64_t sampling_chain(struct sampling *s, size_t axis, double length,
                        struct random *r, double *gained);

/* Return the area (volume) that two disks (balls) of this radius with
   centres at this distance have in common, (6.14, eq:lens), (6.15,
   eq:lens3), and that of the segment (cap) behind a line (plane) at this
   distance from the centre. Require 2 or 3 dimensions, distance >= 0. */
double sampling_overlap(size_t dimensions, double radius, double distance);
double sampling_segment(size_t dimensions, double radius, double distance);

#endif
