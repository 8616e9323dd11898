/* Two bodies, one relative to the other, and how closely they pass. */
#ifndef PAIR_H
#define PAIR_H

#include <math.h>

/* Body j relative to body i. The functions are inline, and compute only
   what is needed, since for millions of pairs storing and loading these
   numbers would take longer than computing them. */
struct pair {
    double r2, v2, rv; /* r . r, m^2; v . v, m^2/s^2; r . v, m^2/s */
};

/* Adds the terms of one axis, along which the bodies are r apart, m, and
   have the relative velocity v, m/s. */
static inline void pair_add(struct pair *p, double r, double v)
{
    p->r2 += r * r;
    p->v2 += v * v;
    p->rv += r * v;
}

/* Returns the square of the smallest distance on straight paths, m^2
   (12.12, eq:pair-nearest); 0 where rounding makes it negative. */
static inline double pair_nearest2(const struct pair *p)
{
    return fmax(p->r2 - p->rv * p->rv / p->v2, 0);
}

#endif
