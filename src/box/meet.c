/* From chapters/05-disks.nw: edit there, then run make tangle. */
/* checksum 219488868 of the lines below */
/* Computes when two disks meet, also in a periodic box. */
#include "box/falling.h"
#include "box/image.h"

#include <math.h>

double disks_wall_time(double x, double v, double radius, double length)
{
    const double way = v > 0 ? length - radius - x : radius - x;
    if (v == 0)
        return INFINITY;
    return way / v > 0 ? way / v : 0;
}

double disks_pair_time(const double separation[], const double closing[],
                       double distance)
{
    const double b = dot(separation, closing);
    const double c = dot(separation, separation) - distance * distance;
    const double disc = b * b - dot(closing, closing) * c;
    if (b >= 0 || disc < 0)
        return INFINITY;
    return c <= 0 ? 0 : c / (sqrt(disc) - b);
}

void disks_separation(const struct disks *d, const double a[],
                      const double b[], double separation[])
{
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        const double x = b[k] - a[k];
        separation[k] = x - d->box[k] * nearest_whole(x * inverse(d, k));
    }
}

double disks_replan_distance(const struct disks *d)
{
    double least = INFINITY, widest = 0;
    for (size_t k = 0; k < d->dimensions; ++k)
        if (disks_wraps(d, k))
            least = fmin(least, d->box[k]);
    for (size_t i = 0; i < d->count; ++i)
        widest = fmax(widest, d->disk[i].radius);
    const double spare = least / 2 - 2 * widest;
    return least == INFINITY       ? INFINITY
           : spare >= 1e-6 * least ? 0.999 * spare / 3
                                   : 0;
}

double disks_meeting(const struct disks *d, size_t i, size_t j, double at)
{
    const struct disk *a = &d->disk[i], *b = &d->disk[j];
    const double last = a->since > b->since ? a->since : b->since;
    const double wait = at - last;
    double x[DISKS_AXES], v[DISKS_AXES];
    for (size_t k = 0; k < DISKS_AXES; ++k) {
        v[k] = b->velocity[k] - a->velocity[k];
        x[k] = (b->position[k] + b->velocity[k] * (last - b->since)) -
               (a->position[k] + a->velocity[k] * (last - a->since));
        if (d->boundary != DISKS_WALLS) {
            const double then = x[k] + v[k] * wait;
            x[k] -= d->box[k] * nearest_whole(then * inverse(d, k));
        }
    }
    if (d->gravity > 0)
        falling_between(d, a, b, x, v);
    return last + disks_pair_time(x, v, a->radius + b->radius);
}
