/* From chapters/09-gravity.nw: edit there, then run make tangle. */
/* checksum 676897934 of the lines below */
/* Gravity between bodies: pair by pair, or on a block of sixteen bodies. */
#ifndef PULL_H
#define PULL_H

#include "forces/gravity.h"

#include <math.h>
#include <stddef.h>

/* Adds to a[] the accelerations of all bodies due to each other. */
static inline void add_pairs(const struct gravity *g, const double x[],
                             double a[])
{
    const size_t n = g->bodies;
    const double *y = x + n, *z = y + n, *m = g->mass;
    double *b = a + n, *c = b + n;
    const double least = g->softening * g->softening;
    for (size_t i = 0; i < n; ++i)
        for (size_t j = i + 1; j < n; ++j) {
            const double dx = x[j] - x[i], dy = y[j] - y[i];
            const double dz = z[j] - z[i];
            const double s = dx * dx + dy * dy + dz * dz + least;
            const double w = g->k2 / (s * sqrt(s));
            const double to_i = w * m[j], to_j = w * m[i];
            a[i] += to_i * dx;
            b[i] += to_i * dy;
            c[i] += to_i * dz;
            a[j] -= to_j * dx;
            b[j] -= to_j * dy;
            c[j] -= to_j * dz;
        }
}

enum { BLOCK = 16 }; /* two or more vector registers */

/* A block of bodies: positions, and sums of their accelerations. */
struct block {
    double x[BLOCK], y[BLOCK], z[BLOCK];
    double a[BLOCK], b[BLOCK], c[BLOCK];
};

/* Adds the accelerations of a block due to a mass m at (x, y, z), without
   the factor k2. `least` is the squared softening. `self` is the index of
   that mass in the block, or at least BLOCK if it is in another block. */
static inline void pull_by(double m, double x, double y, double z,
                           double least, size_t self, struct block *o)
{
    for (size_t k = 0; k < BLOCK; ++k) {
        const double dx = x - o->x[k], dy = y - o->y[k], dz = z - o->z[k];
        const double s =
            dx * dx + dy * dy + dz * dz + (k == self ? 1 : least);
        const double w = m / (s * sqrt(s));
        o->a[k] += w * dx;
        o->b[k] += w * dy;
        o->c[k] += w * dz;
    }
}

/* Returns the block of bodies i to end - 1, padded with the last body. */
static inline struct block block_of(const struct gravity *g,
                                    const double x[], size_t i, size_t end)
{
    struct block o = {{0}, {0}, {0}, {0}, {0}, {0}};
    for (size_t k = 0; k < BLOCK; ++k) {
        const size_t at = i + k < end ? i + k : end - 1;
        o.x[k] = x[at];
        o.y[k] = x[g->bodies + at];
        o.z[k] = x[2 * g->bodies + at];
    }
    return o;
}

#endif
