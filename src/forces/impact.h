/* The moments of contact, found inside a step and resolved one by one. */
#ifndef IMPACT_H
#define IMPACT_H

#include "forces/spheres.h"
#include "forces/stepping.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Contacts whose moments are found. To be read, and set to 0: the counts.
 */
struct impact {
    uint64_t simultaneous; /* contacts at the moment of the one before */
    uint64_t grazing;      /* contacts of the cubics that the method's path
                              has not */
    double least;          /* m; may be set, to what counts as a hair: of
                              the gaps whose smallest width in a part is
                              within it of 0, the width nearest to 0 */
    uint64_t parts;        /* of steps, in which contacts were looked for */
    uint64_t pairs;        /* pairs examined in these parts */
    uint64_t curves;       /* gaps that were followed: for each the products
                              of two control points that it took */
    uint64_t roots;        /* of these, those that had a root */
    size_t resting;        /* coordinates that walls hold, now */
    bool crowded;          /* the last step was given up: its contacts are
                              too many, or bodies rest on each other */
    size_t between[2];     /* if so: bodies; the same twice: at a wall */
    /* ---- private */
    const struct scene *scene;
    struct spheres *spheres;
    struct stepping *stepping;
    struct stepping_forces forces; /* those that no wall takes up */
    enum stepping_end end;         /* of the step so far */
    signed char *held;   /* [3 * bodies] the side of the wall, or 0 */
    size_t lifted;       /* a coordinate that a wall would have to pull */
    double *note;        /* of the stepping, where the part begins */
    double *control;     /* [3 * bodies][10] of the paths in the part, m */
    size_t degree;       /* of the paths */
    double *low, *high;  /* [3 * bodies] between which each lies, m */
    double *pull;        /* [3 * bodies] accelerations, m/s^2 */
    size_t *order, axis; /* the bodies along it; 3: there is none */
    struct impact_gap *gap;
    size_t gaps, capacity;
    bool waiting; /* the last step of its own length ends at a contact */
};

/* Prepares to find the contacts of *p in the steps of *s, which has not
   begun; both, and the scene, have to outlive *i and to stay where they
   are. From then on walls hold in the forces of *s what rests on them.
   Returns false, with nothing to free, if memory runs out. */
bool impact_create(struct impact *i, struct spheres *p, struct stepping *s);
void impact_free(struct impact *i);

/* Takes a step of s->dt > 0 with all its contacts; adds how many there were
   to *met. STEPPING_STUCK with crowded: x and v are those of the moment at
   which it was given up. Sources: (11.8, eq:gap-control), (11.9,
   eq:gap-newton), (11.10, eq:rest). */
enum stepping_end impact_step(struct impact *i, uint64_t *met);

#endif
