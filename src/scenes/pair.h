/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 452283049 of the lines below */
/* Two bodies as the first one sees the second: how near they pass. */
#ifndef PAIR_H
#define PAIR_H

#include <math.h>

/* Two bodies, seen from the first. */
struct pair {
    double r2, v2, rv; /* squared distance, m^2, and speed; r . v */
};

/* Adds what is along an axis to the sums: r, m, and v, m/s. */
static inline void pair_add(struct pair *p, double r, double v)
{
    p->r2 += r * r;
    p->v2 += v * v;
    p->rv += r * v;
}

/* The square of the distance at which they do, m^2, if they pass at all.
   Source: (12.12, eq:pair-nearest). */
static inline double pair_nearest2(const struct pair *p)
{
    return fmax(p->r2 - p->rv * p->rv / p->v2, 0);
}

#endif
