/* Computes the relative motion of two bodies and their closest approach. */
#ifndef PAIR_H
#define PAIR_H

#include <math.h>

/* Motion of body j relative to body i. The functions are inline: for
   millions of pairs, storing and loading these numbers would take longer
   than computing them. */
struct pair {
    double r2, v2, rv; /* r . r, m^2; v . v, m^2/s^2; r . v, m^2/s */
};

/* Adds the terms of an axis. r (m) and v (m/s) are the components of the
   relative position and velocity along it. */
static inline void pair_add(struct pair *p, double r, double v)
{
    p->r2 += r * r;
    p->v2 += v * v;
    p->rv += r * v;
}

/* Returns the square of the smallest distance (in m^2) on straight paths
   (12.12, eq:pair-nearest), or 0 if rounding makes it negative. */
static inline double pair_nearest2(const struct pair *p)
{
    return fmax(p->r2 - p->rv * p->rv / p->v2, 0);
}

#endif
