/* The times of contacts, found inside a step and resolved one by one. */
#ifndef IMPACT_H
#define IMPACT_H

#include "forces/spheres.h"
#include "forces/stepping.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The contacts of a run. The counts may be read and set to 0. */
struct impact {
    uint64_t simultaneous; /* contacts at the time of the last one */
    uint64_t grazing;      /* of paths, not confirmed by the method */
    double least;          /* minimum of a gap nearest to 0, m; to be set to
                              the largest that counts */
    uint64_t parts;        /* parts of steps searched for contacts */
    uint64_t pairs;        /* pairs examined in these parts */
    uint64_t curves;       /* gaps followed; each needs a product of two
                              control points */
    uint64_t roots;        /* followed gaps that had a root */
    size_t resting;        /* coordinates held by walls now */
    bool crowded;          /* the last step was abandoned: too many
                              contacts, or bodies resting on each other */
    size_t between[2];     /* then the bodies; equal: a body at a wall */
    /* ---- private */
    const struct scene *scene;
    struct spheres *spheres;
    struct stepping *stepping;
    struct stepping_forces forces; /* without the forces of walls */
    enum stepping_end end;         /* result of the step so far */
    signed char *held;   /* [3 * bodies] side of the holding wall, or 0 */
    size_t lifted;       /* coordinate that a wall would have to pull */
    double *note;        /* state of the stepping when the part begins */
    double *control;     /* [3 * bodies][10] of the paths, m */
    size_t degree;       /* of the paths */
    double *low, *high;  /* [3 * bodies] limits of each path, m */
    double *pull;        /* [3 * bodies] accelerations, m/s^2 */
    size_t *order, axis; /* bodies sorted along axis; 3: not sorted */
    struct impact_gap *gap;
    size_t gaps, capacity;
    bool waiting; /* the last adaptive step ended at a contact */
};

/* Prepares to find the contacts of *p in the steps of *s, which has not
   begun; both, and the scene, must outlive *i and must not move. From then
   on walls cancel forces on bodies resting on them. Returns false, with
   nothing to free, if memory runs out. */
bool impact_create(struct impact *i, struct spheres *p, struct stepping *s);
void impact_free(struct impact *i);

/* Takes a step of s->dt > 0 with all its contacts; adds their number to
   *met. If it returns STEPPING_STUCK with crowded, x and v are those of the
   time at which the step was abandoned. Sources: (11.8, eq:gap-control),
   (11.9, eq:gap-newton), (11.10, eq:rest). */
enum stepping_end impact_step(struct impact *i, uint64_t *met);

#endif
