/* From chapters/05-disks.nw: edit there, then run make tangle. */
/* checksum 2802085566 of the lines below */
/* Computes scalar products and nearest images of pairs. */
#ifndef IMAGE_H
#define IMAGE_H

#include "box/disks.h"

static inline double dot(const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Returns the whole number nearest to x, for |x| < 2^51. */
static inline double nearest_whole(double x)
{
    const double shift = 6755399441055744; /* 1.5 * 2^52 */
    return x + shift - shift;
}

/* Returns whether the box is periodic along axis k. */
static inline bool wraps(const struct disks *d, size_t k)
{
    return k < d->dimensions && d->box[k] > 0 &&
           (d->boundary == DISKS_PERIODIC ||
            (d->boundary == DISKS_FLOOR && k != 1));
}

/* Returns 1/box[k] (1/m), or 0 if the box is not periodic along axis k. */
static inline double inverse(const struct disks *d, size_t k)
{
    return wraps(d, k) ? 1 / d->box[k] : 0;
}

#endif
