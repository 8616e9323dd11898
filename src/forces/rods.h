/* Stiff springs as rods that keep their length, in steps of leapfrog. */
#ifndef RODS_H
#define RODS_H

#include "scenes/scene.h"
#include "forces/stepping.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A rod: two bodies at a constant distance. */
struct rods_rod {
    uint32_t a, b;
    double square; /* of its length, m^2 */
};

/* The state of a scene with rods, stepped by leapfrog. */
struct rods {
    size_t bodies, count;
    struct rods_rod *rod;
    double *weight; /* [3 * bodies] 1/kg, 0 for a fixed coordinate */
    struct stepping_forces forces; /* of everything but the rods */
    double *acceleration;          /* [3 * bodies] m/s^2 */
    double *before, *last;         /* [3 * bodies] m */
    bool fresh;                    /* acceleration is that at last */
    uint64_t corrections;          /* corrections of single rods, so far */
    uint64_t evaluations;          /* of the forces */
};

/* Makes rods of `count` springs of a scene, as long as the springs are now.
   The forces are all others, and must not depend on velocities. Returns
   false, with nothing to free, if memory runs out. */
bool rods_create(struct rods *p, const struct scene *s,
                 const struct scene_spring spring[], size_t count,
                 struct stepping_forces forces);
void rods_free(struct rods *p);

/* Moves x (m) and v (m/s), arranged as in a scene, by one step of dt, s;
   rods is a struct rods. Returns false if the rods cannot be brought back
   to their lengths. It can be `outside` of a struct motion. Source: (12.7,
   eq:rods-shake). */
bool rods_step(void *rods, double dt, double x[], double v[]);

/* Removes the part of v that would change the length of a rod. Returns
   false if it does not converge. Source: (12.8, eq:rods-rattle). */
bool rods_project(struct rods *p, const double x[], double v[]);

#endif
