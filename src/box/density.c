/* Prepares boxes for sampling, and computes densities at contact. */
#include "box/image.h"
#include "box/sampling.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    s->blocked = malloc(SAMPLING_IMAGES * count * sizeof *s->blocked);
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

/* A straight line on which the centre of disk i may move: the points `from`
   + t `along`, with t (m) from low to high. */
struct line {
    const struct sampling *s;
    size_t i, except; /* the moving disk; a disk that is ignored */
    double from[DISKS_AXES], along[DISKS_AXES];
    double low, high;
    size_t count; /* number of blocked intervals, in s->blocked */
};

/* Marks as blocked the part of the line within `reach` of a centre, whose
   position is relative to l->from. Keeps the blocked intervals sorted. */
static void block(struct line *l, const double centre[], double reach)
{
    double(*blocked)[2] = l->s->blocked;
    const double b = dot(centre, l->along);
    const double square = reach * reach - (dot(centre, centre) - b * b);
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

/* Marks as blocked the part of the line that disk j blocks. In a periodic
   box each of its nearest images, 9 in the plane and 27 in space, can block
   the line. */
static void block_by(struct line *l, size_t j)
{
    const struct disks *d = &l->s->disks;
    const double reach = d->disk[l->i].radius + d->disk[j].radius;
    const int images = d->boundary == DISKS_PERIODIC ? SAMPLING_IMAGES : 1;
    double nearest[DISKS_AXES], image[DISKS_AXES];
    disks_separation(d, l->from, d->disk[j].position, nearest);
    for (int n = 0; n < images; ++n) {
        const int shift[DISKS_AXES] = {n % 3, n / 3 % 3, n / 9};
        if (d->dimensions == 2 && shift[2] > 0)
            break;
        for (size_t k = 0; k < DISKS_AXES; ++k)
            image[k] =
                nearest[k] + d->box[k] * (shift[k] == 2 ? -1 : shift[k]);
        block(l, image, reach);
    }
}

/* Returns the integral of t^power from 0 to t. The power is 0 for a line
   from wall to wall, and 1 or 2 for circles or spheres around another
   disk. */
static double moment(double t, int power)
{
    return (power == 0 ? t : power == 1 ? t * t : t * t * t) / (power + 1);
}

/* Returns the integral of t^power over the unblocked part of the line. Sets
   *low and *high to true if the lower or upper end of the line is
   unblocked. */
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

/* Returns the largest distance (in m) by which disk i can be moved along
   the line. The line ends at a wall or, in a periodic box, where another
   image becomes the nearest. */
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

/* The line starts at the centre of disk j and passes through the centre of
   disk i. Only the part beyond the contact of the two disks is used. */
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

/* Takes the square root of a product, since a difference of squares would
   lose digits for a thin segment. */
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

double sampling_overlap(size_t dimensions, double radius, double distance)
{
    return 2 * sampling_segment(dimensions, radius, distance / 2);
}
