/* Allocates disks, places them, and tests for overlaps. */
#include "box/image.h"
#include "box/plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The disks are aligned so that each fills a cache line of its own. */
bool disks_create(struct disks *d, size_t dimensions, size_t count)
{
    const size_t bytes = count * sizeof *d->disk;
    *d = (struct disks){
        .dimensions = dimensions, .count = count, .restitution = 1};
    d->disk = aligned_alloc(sizeof *d->disk, bytes);
    d->mass = malloc(count * sizeof *d->mass);
    d->hits = calloc(count, sizeof *d->hits);
    if (!d->disk || !d->mass || !d->hits) {
        disks_free(d);
        return false;
    }
    memset(d->disk, 0, bytes);
    for (size_t i = 0; i < count; ++i)
        d->mass[i] = 1;
    return true;
}

void disks_free(struct disks *d)
{
    if (d->plan) {
        free(d->plan->event);
        free(d->plan->hits);
        free(d->plan->time);
    }
    free(d->plan);
    free(d->disk);
    free(d->mass);
    free(d->hits);
    *d = (struct disks){0};
}

/* Returns whether a disk is within the walls. It may overlap a wall by 1e-9
   of the box, to allow for rounding. */
static bool within_walls(const struct disks *d, const double place[],
                         double r)
{
    for (size_t k = 0; k < d->dimensions; ++k)
        if (disks_walled(d, k) && !(place[k] >= r - 1e-9 * d->box[k] &&
                                    place[k] <= d->box[k] * (1 + 1e-9) - r))
            return false;
    return true;
}

/* A NaN in a position makes every comparison false. The disk then counts as
   overlapping. */
bool disks_clash(const struct disks *d, size_t a, size_t b)
{
    double here[DISKS_AXES], there[DISKS_AXES], separation[DISKS_AXES];
    const double r = d->disk[a].radius;
    disks_position(d, a, here);
    if (b == d->count)
        return !within_walls(d, here, r);
    const double least = (r + d->disk[b].radius) * (1 - 1e-9);
    disks_position(d, b, there);
    disks_separation(d, here, there, separation);
    return !(dot(separation, separation) >= least * least);
}

bool disks_fit(const struct disks *d, size_t *a, size_t *b)
{
    for (*a = 0; *a < d->count; ++*a) {
        *b = d->count;
        if (disks_clash(d, *a, *b))
            return false;
        for (*b = *a + 1; *b < d->count; ++*b)
            if (disks_clash(d, *a, *b))
                return false;
    }
    return true;
}

/* A close-packed lattice, stretched over the box. It has `cells` cells of
   width `step` (in m) along each axis, beginning at `from` (in m), and
   `basis` sites in each cell. In the plane it is triangular, with every
   other row shifted by half a step, so a rectangular cell has two sites: a
   corner and the centre. In space it is face-centred cubic. */
struct lattice {
    size_t cells[DISKS_AXES], basis;
    double from[DISKS_AXES], step[DISKS_AXES];
    double nearest; /* smallest distance between sites, m */
};

/* The sites of a cell, as fractions of its width. */
static const double sites[4][DISKS_AXES] = {
    {0, 0, 0}, {.5, .5, 0}, {.5, 0, .5}, {0, .5, .5}};

/* Returns the smallest distance between two sites, m. They are in the same
   cell or in adjacent cells. */
static double nearest_site(const struct lattice *l, size_t dimensions)
{
    double least = INFINITY;
    for (size_t k = 0; k < dimensions; ++k)
        if (l->cells[k] > 1)
            least = fmin(least, l->step[k] * l->step[k]);
    for (size_t s = 1; s < l->basis; ++s) {
        double square = 0;
        for (size_t k = 0; k < dimensions; ++k) {
            const double x = sites[s][k] * l->step[k];
            square += x * x;
        }
        least = fmin(least, square);
    }
    return sqrt(least);
}

/* Stretches the lattice over the box, for disks of radius r, m. Between
   walls, the outermost sites are a radius away from the walls, and half of
   the last cell is not used. */
static void stretch(const struct disks *d, double r, struct lattice *l)
{
    for (size_t k = 0; k < d->dimensions; ++k) {
        const bool walls = disks_walled(d, k);
        const double cells = (double)l->cells[k];
        l->from[k] = walls ? r : 0;
        l->step[k] =
            walls ? (d->box[k] - 2 * r) / (cells - .5) : d->box[k] / cells;
    }
    l->nearest = nearest_site(l, d->dimensions);
}

/* Tries all lattices of l.cells[2] layers with at least `need` cells. Keeps
   in *best the lattice whose sites are farthest apart. */
static void try_layers(const struct disks *d, double r, size_t need,
                       struct lattice l, struct lattice *best)
{
    const size_t layer = (need + l.cells[2] - 1) / l.cells[2];
    const double row = sqrt((double)layer * d->box[0] / d->box[1]);
    for (l.cells[0] = 1;
         l.cells[0] <= layer && (double)l.cells[0] <= 2 + 4 * row;
         ++l.cells[0]) {
        l.cells[1] = (layer + l.cells[0] - 1) / l.cells[0];
        stretch(d, r, &l);
        if (l.nearest > best->nearest * (1 + 1e-12))
            *best = l;
    }
}

/* Returns the lattice with at least this number of sites whose sites are
   farthest apart. Disks in the plane have one layer. For spheres, it is
   never best to have more than twice as many layers as in a cubic
   lattice. */
static struct lattice best_lattice(const struct disks *d, double r,
                                   size_t places)
{
    struct lattice best = {.nearest = 0}, l = {.cells = {1, 1, 1}};
    l.basis = d->dimensions == 2 ? 2 : 4;
    const size_t need = (places + l.basis - 1) / l.basis;
    const double cube =
        (double)need * d->box[2] * d->box[2] / (d->box[0] * d->box[1]);
    for (double n = -1; n <= 0 || n * n * n <= 8 * cube; ++n) {
        try_layers(d, r, need, l, &best);
        ++l.cells[2];
        if (d->dimensions == 2)
            break;
    }
    return best;
}

/* Fills place with the position of a site, m. The sites are numbered cell
   by cell. */
static void place_of_site(const struct disks *d, const struct lattice *l,
                          size_t site, double place[])
{
    const double *part = sites[site % l->basis];
    site /= l->basis;
    for (size_t k = 0; k < d->dimensions; ++k) {
        const size_t cell = site % l->cells[k];
        site /= l->cells[k];
        place[k] = l->from[k] + ((double)cell + part[k]) * l->step[k];
    }
}

/* Returns the number of the widest disk if no other is as wide, or else
   count. Sets *r to the largest radius of the other disks, m. A single
   large disk, such as a Brownian particle, is placed in the middle, since a
   lattice made for it would waste nearly all the space. */
static size_t odd_one_out(const struct disks *d, double *r)
{
    size_t big = 0;
    *r = d->count > 1 ? 0 : d->disk[0].radius;
    for (size_t i = 1; i < d->count; ++i)
        if (d->disk[i].radius > d->disk[big].radius)
            big = i;
    for (size_t i = 0; i < d->count; ++i)
        if (i != big)
            *r = fmax(*r, d->disk[i].radius);
    return d->disk[big].radius > *r ? big : d->count;
}

/* Returns whether the large disk in the middle overlaps a disk of radius r
   (in m) at this position. */
static bool covered(const struct disks *d, size_t big, double r,
                    const double place[])
{
    double square = 0;
    if (big == d->count)
        return false;
    const double reach = d->disk[big].radius + r;
    for (size_t k = 0; k < d->dimensions; ++k) {
        const double x = place[k] - d->box[k] / 2;
        square += x * x;
    }
    return square < reach * reach;
}

/* Returns the number of sites that the large disk does not cover. */
static size_t count_free(const struct disks *d, const struct lattice *l,
                         size_t big, double r)
{
    const size_t all = l->basis * l->cells[0] * l->cells[1] * l->cells[2];
    double place[DISKS_AXES];
    size_t free = 0;
    for (size_t site = 0; site < all; ++site) {
        place_of_site(d, l, site, place);
        free += !covered(d, big, r, place);
    }
    return free;
}

/* Places all disks except the large one on the uncovered sites, and spreads
   the vacancies evenly. */
static void fill_lattice(struct disks *d, const struct lattice *l,
                         size_t big, double r, size_t free)
{
    const size_t small = d->count - (big < d->count);
    double place[DISKS_AXES] = {0};
    size_t put = 0, seen = 0;
    for (size_t site = 0; put < small; ++site) {
        place_of_site(d, l, site, place);
        if (covered(d, big, r, place))
            continue;
        if (seen == (size_t)((uint64_t)put * free / small)) {
            struct disk *to = &d->disk[put + (put >= big)];
            memcpy(to->position, place, sizeof place);
            ++put;
        }
        ++seen;
    }
}

/* If the large disk leaves too few sites free, requests as many more sites
   as are missing, and tries again. */
bool disks_place_lattice(struct disks *d)
{
    double r;
    const size_t big = odd_one_out(d, &r);
    const size_t small = d->count - (big < d->count);
    struct lattice l;
    size_t places = small, free;
    for (size_t k = 0; k < d->dimensions; ++k)
        if (disks_walled(d, k) && d->box[k] < 2 * r)
            return false;
    do {
        l = best_lattice(d, r, places);
        if (!(l.nearest >= 2 * r))
            return false;
        free = count_free(d, &l, big, r);
        places += free < small ? small - free : 0;
    } while (free < small);
    fill_lattice(d, &l, big, r, free);
    for (size_t k = 0; big < d->count && k < d->dimensions; ++k)
        d->disk[big].position[k] = d->box[k] / 2;
    return big == d->count || !disks_clash(d, big, d->count);
}

/* Returns whether disk i overlaps a disk with a smaller number. */
static bool overlaps(const struct disks *d, size_t i)
{
    const struct disk *a = &d->disk[i];
    for (size_t j = 0; j < i; ++j) {
        const double least = a->radius + d->disk[j].radius;
        double separation[DISKS_AXES];
        disks_separation(d, d->disk[j].position, a->position, separation);
        if (dot(separation, separation) < least * least)
            return true;
    }
    return false;
}

/* Moves disk a to a random position in the box, at least a radius away from
   walls. Returns false if the box is too narrow for the disk. */
static bool throw_disk(const struct disks *d, struct disk *a,
                       struct random *r)
{
    for (size_t k = 0; k < d->dimensions; ++k) {
        const double edge = disks_walled(d, k) ? a->radius : 0;
        if (!(d->box[k] >= 2 * edge))
            return false;
        a->position[k] = random_between(r, edge, d->box[k] - edge);
    }
    return true;
}

/* Gives up after 10 000 tries for a disk, since earlier disks are not moved
   aside. This works up to a packing fraction of about a half in the plane.
   Not all allowed states are equally likely, as the first disks have more
   choice. So the result can start a run, which forgets its start, but is
   not a sample (see chapter 6). */
bool disks_place_random(struct disks *d, struct random *r)
{
    enum { TRIES = 10000 };
    for (size_t i = 0; i < d->count; ++i) {
        int tries = 0;
        do {
            if (tries++ == TRIES || !throw_disk(d, &d->disk[i], r))
                return false;
        } while (overlaps(d, i));
    }
    return true;
}

/* Folds all positions back into the box. Resets all counters, since they
   belong to the run that has ended. */
void disks_settle(struct disks *d)
{
    for (size_t i = 0; i < d->count; ++i) {
        struct disk *a = &d->disk[i];
        double place[DISKS_AXES], velocity[DISKS_AXES];
        disks_position(d, i, place);
        disks_velocity(d, i, velocity);
        disks_fold(d, place);
        memcpy(a->position, place, sizeof place);
        memcpy(a->velocity, velocity, sizeof velocity);
        a->since = 0;
        d->hits[i] = 0;
    }
    d->now = 0;
    d->collisions = d->wall_collisions = d->standing = 0;
    d->virial = 0;
    memset(d->impulse, 0, sizeof d->impulse);
}
