/* From chapters/06-room.nw: edit there, then run make tangle. */
/* checksum 2790736230 of the lines below */
/* Direct sampling, Metropolis moves, densities at contact from slides. */
#include "box/sampling.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    IMAGES = 27,   /* of a disk near a cell of a periodic box */
    ENOUGH = 10,   /* throws that make a share worth believing */
    TRIES = 100000 /* to place a small disk */
};

static double dot(const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The whole number nearest to x, for |x| < 2^51. */
static double whole(double x)
{
    const double shift = 6755399441055744; /* 1.5 * 2^52 */
    return x + shift - shift;
}

/* The square of the distance of two places, in a periodic box that of the
   nearest images. */
static double squared(const struct sampling *s, const double a[],
                      const double b[])
{
    double sum = 0;
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        double x = b[k] - a[k];
        x -= s->disks.box[k] * whole(x * s->per_side[k]);
        sum += x * x;
    }
    return sum;
}

/* Says whether disk i could be at this place without overlapping one of
   the first `among` that it sees. */
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

bool sampling_create(struct sampling *s, size_t dimensions,
                     enum disks_boundary boundary, const double box[],
                     size_t large, double radius, size_t small,
                     double small_radius)
{
    const size_t count = large + small;
    *s = (struct sampling){.large = large};
    if (!disks_create(&s->disks, dimensions, count))
        return false;
    s->disks.boundary = boundary;
    for (size_t k = 0; k < dimensions; ++k) {
        s->disks.box[k] = box[k];
        s->per_side[k] = boundary == DISKS_PERIODIC ? 1 / box[k] : 0;
    }
    for (size_t i = 0; i < count; ++i)
        s->disks.disk[i].radius = i < large ? radius : small_radius;
    s->blocked = malloc(IMAGES * count * sizeof *s->blocked);
    if (!s->blocked)
        sampling_free(s);
    return s->blocked != NULL;
}

void sampling_free(struct sampling *s)
{
    disks_free(&s->disks);
    free(s->blocked);
    s->blocked = NULL;
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
        if (reached[i + 1] >= ENOUGH)
            last = log((double)reached[i + 1] / (double)reached[i]);
        sum += last;
    }
    free(reached);
    return sum;
}

/* Picks one that is to move: a large or a small one with equal odds. */
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

/* Places the large ones in the middles of cells; says whether they fit. */
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

/* How far disk i can go up along the axis until it touches disk j, and how
   far it will then be behind. Rounding may have it there already. */
static double way_to(const struct sampling *s, size_t i, size_t j,
                     size_t axis, double *behind)
{
    const struct disk *from = &s->disks.disk[i], *to = &s->disks.disk[j];
    const double least = from->radius + to->radius;
    double square = least * least, ahead = 0;
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        double x = to->position[k];
        x -= from->position[k];
        x -= s->disks.box[k] * whole(x * s->per_side[k]);
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

/* The disk that disk i will touch first when it goes up along the axis by
   at most *way, which becomes that way, and how far i is then behind it;
   i: none. */
static size_t find_next(const struct sampling *s, size_t i, size_t axis,
                        double *way, double *behind)
{
    size_t next = i;
    double apart = 0;
    for (size_t j = 0; j < s->large; ++j) {
        const double to = j == i ? INFINITY : way_to(s, i, j, axis, &apart);
        if (to < *way) {
            *way = to;
            *behind = apart;
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
/* A straight line for the centre of disk i: place = from + t along, with t
   from low to high. */
struct line {
    const struct sampling *s;
    size_t i, except; /* the disk that slides; one that does not block */
    double from[DISKS_AXES], along[DISKS_AXES];
    double low, high;
    size_t count; /* of blocked stretches, in s->blocked */
};

/* Blocks what a disk with its centre `apart` from the line's beginning
   takes away, in the order of the beginnings. */
static void block(struct line *l, const double apart[], double reach)
{
    double(*blocked)[2] = l->s->blocked;
    const double b = dot(apart, l->along);
    const double square = reach * reach - (dot(apart, apart) - b * b);
    if (square <= 0)
        return;
    const double half = sqrt(square);
    if (b + half <= l->low || b - half >= l->high)
        return;
    size_t k = l->count++;
    for (; k > 0 && blocked[k - 1][0] > b - half; --k)
        memcpy(blocked[k], blocked[k - 1], sizeof blocked[k]);
    blocked[k][0] = b - half;
    blocked[k][1] = b + half;
}

/* Blocks the line by disk j, in a periodic box by each image near it. */
static void block_by(struct line *l, size_t j)
{
    const struct disks *d = &l->s->disks;
    const double reach = d->disk[l->i].radius + d->disk[j].radius;
    const int images = d->boundary == DISKS_PERIODIC ? IMAGES : 1;
    double apart[DISKS_AXES], image[DISKS_AXES];
    disks_separation(d, l->from, d->disk[j].position, apart);
    for (int n = 0; n < images; ++n) {
        const int shift[DISKS_AXES] = {n % 3, n / 3 % 3, n / 9};
        if (d->dimensions == 2 && shift[2] > 0)
            break;
        for (size_t k = 0; k < DISKS_AXES; ++k)
            image[k] =
                apart[k] + d->box[k] * (shift[k] == 2 ? -1 : shift[k]);
        block(l, image, reach);
    }
}

/* The integral of t^power from 0 to t. */
static double moment(double t, int power)
{
    return (power == 0 ? t : power == 1 ? t * t : t * t * t) / (power + 1);
}

/* The integral of t^power over the free part of the line; *low, *high:
   whether its ends are free. */
static double free_part(struct line *l, int power, bool *low, bool *high)
{
    const struct sampling *s = l->s;
    const size_t seen = l->i < s->large ? s->disks.count : s->large;
    l->count = 0;
    for (size_t j = 0; j < seen; ++j)
        if (j != l->i && j != l->except)
            block_by(l, j);
    double sum = 0, end = l->low;
    for (size_t k = 0; k < l->count; ++k) {
        if (s->blocked[k][0] > end)
            sum += moment(s->blocked[k][0], power) - moment(end, power);
        end = fmax(end, s->blocked[k][1]);
    }
    *low = l->count == 0 || s->blocked[0][0] > l->low;
    *high = end < l->high;
    return *high ? sum + moment(l->high, power) - moment(end, power) : sum;
}

double sampling_wall_density(const struct sampling *s, size_t i, size_t k)
{
    const struct disk *disk = &s->disks.disk[i];
    struct line l = {.s = s, .i = i, .except = i};
    bool low, high;
    memcpy(l.from, disk->position, sizeof l.from);
    l.from[k] = 0;
    l.along[k] = 1;
    l.low = disk->radius;
    l.high = s->disks.box[k] - disk->radius;
    const double length = free_part(&l, 0, &low, &high);
    return length > 0 ? (low + high) / (2 * length) : 0;
}

/* How far disk i can be moved along the line: to a wall, or to where in a
   periodic box another image would be the nearest. */
static double end_of_ray(const struct line *l)
{
    const struct disks *d = &l->s->disks;
    const double r = d->disk[l->i].radius;
    double end = INFINITY;
    for (size_t k = 0; k < d->dimensions; ++k) {
        const double way = d->boundary == DISKS_PERIODIC ? d->box[k] / 2
                           : l->along[k] > 0 ? d->box[k] - r - l->from[k]
                                             : l->from[k] - r;
        if (l->along[k] != 0)
            end = fmin(end, way / fabs(l->along[k]));
    }
    return end;
}

double sampling_pair_density(const struct sampling *s, size_t i, size_t j)
{
    const struct disks *d = &s->disks;
    const struct disk *to = &d->disk[i], *from = &d->disk[j];
    const int power = (int)d->dimensions - 1;
    struct line l = {.s = s, .i = i, .except = j};
    bool low, high;
    memcpy(l.from, from->position, sizeof l.from);
    disks_separation(d, from->position, to->position, l.along);
    const double distance = sqrt(dot(l.along, l.along));
    for (size_t k = 0; k < DISKS_AXES; ++k)
        l.along[k] /= distance;
    l.low = to->radius + from->radius;
    l.high = end_of_ray(&l);
    const double part = free_part(&l, power, &low, &high);
    const double at = power == 1 ? l.low : l.low * l.low;
    return part > 0 && low ? at / part : 0;
}

double sampling_segment(size_t dimensions, double radius, double distance)
{
    const double rest = radius - distance;
    if (rest <= 0)
        return 0;
    if (dimensions == 3)
        return acos(-1) * rest * rest * (2 * radius + distance) / 3;
    return radius * radius * acos(distance / radius) -
           distance * sqrt(rest * (radius + distance));
}

double sampling_overlap(size_t dimensions, double radius, double apart)
{
    return 2 * sampling_segment(dimensions, radius, apart / 2);
}

bool sampling_means_create(struct sampling_means *m, size_t quantities)
{
    *m = (struct sampling_means){.quantities = quantities, .length = 1};
    m->sum = calloc(SAMPLING_BLOCKS * quantities, sizeof *m->sum);
    return m->sum != NULL;
}

void sampling_means_free(struct sampling_means *m)
{
    free(m->sum);
    m->sum = NULL;
}

void sampling_means_add(struct sampling_means *m, size_t quantity,
                        double value)
{
    m->sum[m->blocks * m->quantities + quantity] += value;
}

/* Makes one block of every two. */
static void join_blocks(struct sampling_means *m)
{
    const size_t n = m->quantities;
    m->blocks /= 2;
    m->length *= 2;
    for (size_t b = 0; b < m->blocks; ++b)
        for (size_t q = 0; q < n; ++q)
            m->sum[b * n + q] =
                m->sum[2 * b * n + q] + m->sum[(2 * b + 1) * n + q];
    memset(m->sum + m->blocks * n, 0, m->blocks * n * sizeof *m->sum);
}

void sampling_means_next(struct sampling_means *m)
{
    if (++m->filled < m->length)
        return;
    m->filled = 0;
    if (++m->blocks == SAMPLING_BLOCKS)
        join_blocks(m);
}

double sampling_means_mean(const struct sampling_means *m, size_t quantity)
{
    const double samples = (double)(m->blocks * m->length + m->filled);
    double sum = 0;
    for (size_t b = 0; b < m->blocks + (m->filled > 0); ++b)
        sum += m->sum[b * m->quantities + quantity];
    return samples > 0 ? sum / samples : NAN;
}

double sampling_means_error(const struct sampling_means *m, size_t quantity)
{
    double mean = 0, squares = 0;
    for (size_t b = 0; b < m->blocks; ++b) {
        const double value =
            m->sum[b * m->quantities + quantity] / (double)m->length;
        const double deviation = value - mean;
        mean += deviation / (double)(b + 1);
        squares += deviation * (value - mean);
    }
    const double n = (double)m->blocks;
    return n > 1 ? sqrt(squares / (n - 1) / n) : NAN;
}
