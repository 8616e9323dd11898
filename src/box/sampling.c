/* From chapters/06-room.nw: edit there, then run make tangle. */
/* checksum 1446073242 of the lines below */
/* Samples hard disks directly, by a Markov chain, or by event chains. */
#include "box/sampling.h"

#include "box/image.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    LEAST_SEEN = 10, /* with fewer successful throws a fraction is
                        unreliable */
    TRIES = 100000   /* attempts to place a small disk */
};

/* Returns the squared distance between two positions, m^2. In a periodic
   box this is the distance of the nearest images. */
static double squared(const struct sampling *s, const double a[],
                      const double b[])
{
    double sum = 0;
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        double x = b[k] - a[k];
        x -= s->disks.box[k] * nearest_whole(x * s->per_side[k]);
        sum += x * x;
    }
    return sum;
}

/* Returns whether disk i fits at this position: it must not overlap any of
   the first `among` disks that it interacts with. */
static bool fits(const struct sampling *s, size_t i, const double place[],
                 size_t among)
{
    const struct disk *disk = s->disks.disk;
    const size_t seen = i < s->large || among < s->large ? among : s->large;
    for (size_t j = 0; j < seen; ++j) {
        const double least = disk[i].radius + disk[j].radius;
        if (j != i && squared(s, place, disk[j].position) < least * least)
            return false;
    }
    return true;
}

static void throw_one(const struct sampling *s, size_t i, struct random *r,
                      double place[])
{
    const struct disks *d = &s->disks;
    const double edge = d->boundary == DISKS_WALLS ? d->disk[i].radius : 0;
    for (size_t k = 0; k < d->dimensions; ++k)
        place[k] = random_between(r, edge, d->box[k] - edge);
}

size_t sampling_throw(struct sampling *s, struct random *r)
{
    for (size_t i = 0; i < s->disks.count; ++i) {
        double *place = s->disks.disk[i].position;
        throw_one(s, i, r, place);
        if (!fits(s, i, place, i))
            return i;
    }
    return s->disks.count;
}

double sampling_log_acceptance(struct sampling *s, uint64_t throws,
                               struct random *r)
{
    const size_t count = s->disks.count;
    uint64_t *reached = calloc(count + 1, sizeof *reached);
    double sum = 0, last = 0;
    if (!reached)
        return 0;
    for (uint64_t k = 0; k < throws; ++k)
        ++reached[sampling_throw(s, r)];
    for (size_t i = count; i-- > 0;)
        reached[i] += reached[i + 1];
    for (size_t i = 0; i < count; ++i) {
        if (reached[i + 1] >= LEAST_SEEN)
            last = log((double)reached[i + 1] / (double)reached[i]);
        sum += last;
    }
    free(reached);
    return sum;
}

/* Returns a random disk to move, large or small with equal odds. */
static size_t pick(const struct sampling *s, struct random *r)
{
    const size_t small = s->disks.count - s->large;
    if (small == 0 || random_below(r, 2) == 0)
        return random_below(r, s->large);
    return s->large + random_below(r, small);
}

static bool inside(const struct sampling *s, size_t i, const double place[])
{
    const struct disks *d = &s->disks;
    const double r = d->disk[i].radius;
    for (size_t k = 0; k < d->dimensions; ++k)
        if (d->boundary == DISKS_WALLS &&
            !(place[k] >= r && place[k] <= d->box[k] - r))
            return false;
    return true;
}

bool sampling_try(struct sampling *s, double step, struct random *r)
{
    const size_t i = pick(s, r);
    struct disk *disk = &s->disks.disk[i];
    double place[DISKS_AXES] = {0};
    if (i < s->large)
        for (size_t k = 0; k < s->disks.dimensions; ++k)
            place[k] = disk->position[k] + random_between(r, -step, step);
    else
        throw_one(s, i, r, place);
    if (!inside(s, i, place) || !fits(s, i, place, s->disks.count))
        return false;
    memcpy(disk->position, place, sizeof place);
    return true;
}

/* Places the large disks at the centres of the cells of a square or cubic
   grid. Returns whether they fit. */
static bool place_on_grid(struct sampling *s)
{
    const struct disks *d = &s->disks;
    size_t m = 1;
    while (m * m * (d->dimensions == 3 ? m : 1) < s->large)
        ++m;
    for (size_t i = 0; i < s->large; ++i) {
        double *place = d->disk[i].position;
        const size_t cell[DISKS_AXES] = {i % m, i / m % m, i / m / m};
        for (size_t k = 0; k < d->dimensions; ++k)
            place[k] = ((double)cell[k] + 0.5) * d->box[k] / (double)m;
        if (!inside(s, i, place) || !fits(s, i, place, i))
            return false;
    }
    return true;
}

bool sampling_start(struct sampling *s, struct random *r)
{
    struct disks large = s->disks;
    large.count = s->large;
    if (!disks_place_lattice(&large) && !place_on_grid(s))
        return false;
    for (size_t i = s->large; i < s->disks.count; ++i) {
        double *place = s->disks.disk[i].position;
        size_t tries = 0;
        do
            throw_one(s, i, r, place);
        while (!fits(s, i, place, i) && ++tries < TRIES);
        if (tries == TRIES)
            return false;
    }
    return true;
}

/* Returns the distance (in m) by which disk i can move in the positive
   direction of the axis until it touches disk j. Sets *behind to the
   distance between the disks along the axis at contact, m. */
static double way_to(const struct sampling *s, size_t i, size_t j,
                     size_t axis, double *behind)
{
    const struct disk *from = &s->disks.disk[i], *to = &s->disks.disk[j];
    const double least = from->radius + to->radius;
    double square = least * least, ahead = 0;
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        double x = to->position[k];
        x -= from->position[k];
        x -= s->disks.box[k] * nearest_whole(x * s->per_side[k]);
        if (k == axis)
            ahead = x < 0 ? x + s->disks.box[k] : x;
        else
            square -= x * x;
    }
    if (square <= 0)
        return INFINITY;
    *behind = sqrt(square);
    return fmax(ahead - *behind, 0);
}

/* Returns the disk that disk i touches first when it moves in the positive
   direction of the axis by at most *way (in m), or i if it touches none.
   Sets *way to the distance to the contact and *behind to the distance
   between the two disks along the axis at contact, m. */
static size_t find_next(const struct sampling *s, size_t i, size_t axis,
                        double *way, double *behind)
{
    size_t next = i;
    double gap = 0;
    for (size_t j = 0; j < s->large; ++j) {
        const double to = j == i ? INFINITY : way_to(s, i, j, axis, &gap);
        if (to < *way) {
            *way = to;
            *behind = gap;
            next = j;
        }
    }
    return next;
}

static void push(struct sampling *s, size_t i, size_t axis, double way)
{
    double *const x = &s->disks.disk[i].position[axis];
    *x += way;
    *x -= s->disks.box[axis] * floor(*x * s->per_side[axis]);
}

uint64_t sampling_chain(struct sampling *s, size_t axis, double length,
                        struct random *r, double *gained)
{
    size_t i = random_below(r, s->large), idle = 0;
    for (uint64_t lifts = 0;; ++lifts) {
        double way = length, behind = 0;
        const size_t next = find_next(s, i, axis, &way, &behind);
        push(s, i, axis, way);
        idle = length - way < length ? 0 : idle + 1;
        length -= way;
        if (next == i || idle > s->large)
            return lifts;
        *gained += behind;
        i = next;
    }
}
