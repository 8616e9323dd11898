/* Samples hard disks directly, by a Markov chain, or by event chains. */
#ifndef SAMPLING_H
#define SAMPLING_H

#include "box/disks.h"
#include "toolbox/random.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { SAMPLING_IMAGES = 27 }; /* images of a disk that may reach a cell */

/* Hard disks or spheres without motion. The large disks come first, then
   small ideal disks. Small disks must not overlap large disks or walls, but
   may overlap each other. */
struct sampling {
    struct disks disks; /* all disks; velocities are not used */
    size_t large;
    double per_side[DISKS_AXES]; /* 1/box, 1/m; 0 where there are walls */
    double (*blocked)[2]; /* scratch: blocked intervals of a line, m */
};

/* Prepares a box with this boundary and these sides (m, one for each
   dimension) for `large` disks or spheres of the radius `radius` (m) and
   `small` ideal disks of the radius `small_radius`. Places no disk. Returns
   false, with nothing to free, if memory runs out. */
bool sampling_create(struct sampling *s, size_t dimensions,
                     enum disks_boundary boundary, const double box[],
                     size_t large, double radius, size_t small,
                     double small_radius);
void sampling_free(struct sampling *s);

/* Places the disks one after another at random, up to the first that
   overlaps, and returns the number of disks that fitted. If all fitted,
   their positions are a sample of (6.1, eq:throw). */
size_t sampling_throw(struct sampling *s, struct random *r);

/* Estimates the natural logarithm of the fraction of throws in which all
   disks fit, from the given number of throws. The result is a sum over the
   disks. If a disk fitted in fewer than ten throws, the term of the last
   disk before it is used instead, which overestimates the result at low
   densities. */
double sampling_log_acceptance(struct sampling *s, uint64_t throws,
                               struct random *r);

/* Return estimates from one configuration, whose means over a run are
   densities (in 1/m): that of large disk i at the two walls perpendicular
   to axis k, and that of pair distances at contact, found by sliding disk i
   away from disk j (6.6, eq:slide). Require positions without overlaps. */
double sampling_wall_density(const struct sampling *s, size_t i, size_t k);
double sampling_pair_density(const struct sampling *s, size_t i, size_t j);

/* Tries a move of a Markov chain (6.7, eq:metropolis) with a random disk. A
   large disk moves by up to +-step (m) along each axis, a small disk to any
   place. Returns whether the disk moved. If not, the old configuration
   counts again. Requires positions without overlaps. */
bool sampling_try(struct sampling *s, double step, struct random *r);

/* Places the large disks on a close-packed lattice, or else on a grid, and
   the small disks at random. Returns false if they do not fit. */
bool sampling_start(struct sampling *s, struct random *r);

/* Runs an event chain. Moves a random large disk in the positive direction
   of an axis until it touches another disk, then moves the touched disk,
   and so on, by a total of `length` (m). The distribution (6.1, eq:throw)
   stays unchanged, because the chain satisfies global balance (6.9,
   eq:global-balance). Returns the number of contacts. Adds to *gained, at
   each contact, the distance between the two disks along the axis (m).
   Requires a periodic box, no small disks, and positions without
   overlaps. */
uint64_t sampling_chain(struct sampling *s, size_t axis, double length,
                        struct random *r, double *gained);

/* Return an area (a volume for balls), for distance >= 0 in 2 or 3
   dimensions. sampling_overlap: the part that two disks of this radius with
   centres at this distance have in common (6.14, eq:lens), (6.15,
   eq:lens3). sampling_segment: the segment (cap) of a disk (ball) beyond a
   line (plane) at this distance from the centre. */
double sampling_overlap(size_t dimensions, double radius, double distance);
double sampling_segment(size_t dimensions, double radius, double distance);

#endif
