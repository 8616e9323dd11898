/* Finds the times of contacts in a step, and resolves them one by one. */
#ifndef IMPACT_H
#define IMPACT_H

#include "forces/spheres.h"
#include "forces/stepping.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The contacts of a run. The counts may be read and set to 0. */
struct impact {
    uint64_t simultaneous; /* contacts at the same time as an earlier one */
    uint64_t grazing;      /* contacts found on paths but not confirmed by
                              the method */
    double least;          /* local minimum of a gap's width that is
                              nearest to 0, m; set it first to the largest
                              width of interest, or to 0 to skip the
                              search */
    uint64_t parts;        /* parts of steps searched for contacts */
    uint64_t pairs;        /* pairs examined in these parts */
    uint64_t curves;       /* cost of all gaps: number of control points (at
                              walls) or of products of two control points
                              (pairs) */
    uint64_t roots;        /* the same for gaps with a root */
    size_t resting;        /* number of coordinates now held by walls */
    bool crowded;          /* the last step was abandoned: too many
                              contacts, or bodies resting on each other */
    size_t between[2]; /* if crowded: the two bodies; equal for a body at a
                          wall */
    /* ---- private */
    const struct scene *scene;
    struct spheres *spheres;
    struct stepping *stepping;
    struct stepping_forces forces; /* without the forces of walls */
    enum stepping_end end;         /* result of the step so far */
    signed char *held;   /* [3 * bodies] side of the wall on which the body
                            rests, -1 or 1; 0: none */
    size_t lifted;       /* coordinate that is pulled off its wall */
    double *note;        /* state of the stepping at the start of the
                            part */
    double *control;     /* [3 * bodies][10] control points, m */
    size_t degree;       /* of the paths */
    double *low, *high;  /* [3 * bodies] box around each path, m */
    double *pull;        /* [3 * bodies] accelerations, m/s^2 */
    size_t *order, axis; /* bodies, sorted along axis unless axis is 3 */
    struct impact_gap *gap;
    size_t gaps, capacity;
    bool waiting; /* the last adaptive step ended at a contact */
};

/* Prepares *i to find the contacts of *p in the steps of *s, which must
   not have begun. *p, *s and the scene must outlive *i and keep their
   addresses. From then on, walls cancel forces on bodies that rest on
   them. Returns false, with nothing to free, if memory runs out. */
bool impact_create(struct impact *i, struct spheres *p, struct stepping *s);
void impact_free(struct impact *i);

/* Takes a step of length s->dt > 0 with all its contacts, and adds their
   number to *met. If the result is STEPPING_STUCK and i->crowded is true, x
   and v are the state in which the step was abandoned. Sources: (11.8,
   eq:gap-control), (11.9, eq:gap-newton), (11.10, eq:rest). */
enum stepping_end impact_step(struct impact *i, uint64_t *met);

#endif
