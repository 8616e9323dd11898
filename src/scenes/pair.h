/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 3071908468 of the lines below */
/* Two bodies as the first one sees the second: how near they pass. */
#ifndef PAIR_H
#define PAIR_H

#include "scenes/scene.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* Two bodies, seen from the first. */
struct pair {
    double r[SCENE_AXES], v[SCENE_AXES]; /* where the second is, m, and its
                                            velocity, m/s */
    double r2, v2, rv; /* squared distance and speed; r . v */
};

/* Sets what is along axis k, and adds it to the sums. */
static inline void pair_set(struct pair *p, size_t k, double r, double v)
{
    p->r[k] = r;
    p->v[k] = v;
    p->r2 += r * r;
    p->v2 += v * v;
    p->rv += r * v;
}

/* Two bodies of a scene. In a periodic box: not their nearest images. */
static inline struct pair pair_of(const struct scene *s, size_t i, size_t j)
{
    const double *x = s->position, *v = s->velocity;
    struct pair p = {.r2 = 0};
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const size_t a = k * s->bodies + i, b = k * s->bodies + j;
        pair_set(&p, k, x[b] - x[a], v[b] - v[a]);
    }
    return p;
}

/* Do they pass, or have they passed, within so much time, s, along straight
   lines? */
static inline bool pair_passes(const struct pair *p, double within)
{
    return fabs(p->rv) <= within * p->v2 && p->v2 > 0;
}

/* The square of the distance at which they do, m^2, if they pass at all.
   Source: (12.11, eq:pair-nearest). */
static inline double pair_nearest2(const struct pair *p)
{
    return fmax(p->r2 - p->rv * p->rv / p->v2, 0);
}

/* From two states of a pair: where it was before, with the way since then,
   m, in place of the velocity. */
static inline struct pair pair_way(const struct pair *before,
                                   const struct pair *after)
{
    struct pair p = {.r2 = 0};
    for (size_t k = 0; k < SCENE_AXES; ++k)
        pair_set(&p, k, before->r[k], after->r[k] - before->r[k]);
    return p;
}

/* The change of the velocity, m/s. */
static inline double pair_changed(const struct pair *before,
                                  const struct pair *after)
{
    double sum = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double u = after->v[k] - before->v[k];
        sum += u * u;
    }
    return sqrt(sum);
}

#endif
