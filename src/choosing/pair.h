/* Two bodies as the first one sees the second: how near they pass. */
#ifndef PAIR_H
#define PAIR_H

#include <math.h>

/* Two bodies, seen from the first. Millions of pairs are asked, and
   calls that hand these numbers over in memory would take longer than to
   find them; so all here is inline, and what is not asked for is not
   computed. */
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

/* Returns the square of the distance at which they pass on straight ways,
   m^2 (12.12, eq:pair-nearest), which rounding may make a little less than
   0. */
static inline double pair_nearest2(const struct pair *p)
{
    return fmax(p->r2 - p->rv * p->rv / p->v2, 0);
}

#endif
