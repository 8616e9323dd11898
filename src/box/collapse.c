/* Tests whether a run must end: inelastic collapse, or disks too slow. */
#include "box/image.h"

#include <math.h>

bool disks_collapsed(const struct disks *d)
{
    return d->standing > 1000 + 10 * d->count;
}

static double square_of_speed(const struct disk *a)
{
    return dot(a->velocity, a->velocity);
}

bool disks_cold(const struct disks *d)
{
    double widest = 0;
    bool moves = false;
    for (size_t i = 0; i < d->count; ++i)
        widest = fmax(widest, d->disk[i].radius);
    for (size_t i = 0; i < d->count; ++i) {
        const struct disk *a = &d->disk[i];
        const double scale =
            fmin(widest > 0 ? widest * widest : 1, d->mass[i]);
        if (square_of_speed(a) * fmin(1, scale) >= 0x1p-900)
            return false;
        for (size_t k = 0; k < d->dimensions; ++k)
            moves = moves || a->velocity[k] != 0;
    }
    return moves && !(d->gravity > 0);
}

/* Returns, after a collision of disk i, whether all disks are too cold.
   Only a gas that loses energy gets cold. Nearly always disk i itself is
   fast enough, so most calls do not examine the other disks. */
static bool may_be_cold(const struct disks *d, size_t i)
{
    return d->restitution < 1 && square_of_speed(&d->disk[i]) < 1e-100 &&
           disks_cold(d);
}

bool disks_over(const struct disks *d, size_t i)
{
    return disks_collapsed(d) || may_be_cold(d, i);
}
