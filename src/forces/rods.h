/* Stiff springs as rods that keep their length, in steps of leapfrog. */
#ifndef RODS_H
#define RODS_H

#include "scenes/scene.h"
#include "forces/stepping.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Two bodies that stay at their distance. */
struct rods_rod {
    uint32_t a, b;
    double square; /* of its length, m^2 */
};

/* A scene with rods in it, in steps of leapfrog. */
struct rods {
    size_t bodies, count;
    struct rods_rod *rod;
    double *weight; /* [3 * bodies] 1/kg, 0 along a fixed coordinate */
    struct stepping_forces forces; /* of all that is no rod */
    double *acceleration;          /* [3 * bodies] m/s^2 */
    double *before, *last;         /* [3 * bodies] m */
    bool fresh;                    /* acceleration belongs to last */
    uint64_t corrections;          /* of one rod, so far */
    uint64_t evaluations;          /* of the forces */
};

/* Makes rods of `count` springs of a scene, as long as the springs are now.
   The forces are those of all else, and must not depend on velocities.
   Returns false, with nothing to free, when there is no memory. */
bool rods_create(struct rods *p, const struct scene *s,
                 const struct scene_spring spring[], size_t count,
                 struct stepping_forces forces);
void rods_free(struct rods *p);

/* Takes x (m) and v (m/s), as they lie in a scene, one step of dt, s, on;
   rods is a struct rods. False: the rods cannot be brought back to their
   lengths. It suits struct motion's door `outside`. Source: (12.7,
   eq:rods-shake). */
bool rods_step(void *rods, double dt, double x[], double v[]);

/* Takes off what in v would change the length of a rod. False: it does not
   come to an end. Source: (12.8, eq:rods-rattle). */
bool rods_project(struct rods *p, const double x[], double v[]);

#endif
