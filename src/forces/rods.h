/* Stiff springs as rods of constant length, stepped by leapfrog. */
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
    double square; /* square of the length, m^2 */
};

/* The state of a scene with rods, stepped by leapfrog. `before` has the
   positions before the drift. `last` has the positions at which the forces
   were last computed. */
struct rods {
    size_t bodies, count;
    struct rods_rod *rod;
    double *weight; /* [3 * bodies] inverse mass, 1/kg; 0 if fixed */
    struct stepping_forces forces; /* all forces except those of rods */
    double *acceleration;          /* [3 * bodies] at x = last, m/s^2 */
    double *before, *last;         /* [3 * bodies] positions, m */
    bool fresh;                    /* whether acceleration is valid */
    uint64_t corrections;          /* number of corrections so far */
    uint64_t evaluations;          /* number of force evaluations */
};

/* Replaces `count` springs of a scene by rods with the current lengths of
   the springs. `forces` are all other forces, which must not depend on
   velocities. Returns false, with nothing to free, if memory runs out. */
bool rods_create(struct rods *p, const struct scene *s,
                 const struct scene_spring spring[], size_t count,
                 struct stepping_forces forces);
void rods_free(struct rods *p);

/* Moves x (in m) and v (in m/s), arranged as in a scene, by one step of dt
   (in s). `rods` points to a struct rods. Returns false if the rods cannot
   be brought back to their lengths. May be used as `outside` of a struct
   motion. Source: (12.7, eq:rods-shake). */
bool rods_step(void *rods, double dt, double x[], double v[]);

/* Removes from v the part that would change the lengths of rods. Returns
   false if the iteration does not converge. Source: (12.8,
   eq:rods-rattle). */
bool rods_project(struct rods *p, const double x[], double v[]);

#endif
