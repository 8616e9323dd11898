/* Bodies on ellipses around the bodies before them, perturbed by kicks. */
#ifndef JACOBI_H
#define JACOBI_H

#include "forces/stepping.h"
#include "scenes/scene.h"

#include <stdbool.h>
#include <stddef.h>

/* Bodies in the order of their scene. In arrays, coordinate k of body i has
   the index k * bodies + i. */
struct jacobi {
    size_t bodies;
    double k2;
    const double *mass; /* [bodies], owned by the caller; the mass of body 0
                           is not 0 */
    double *fraction,   /* [bodies] m_i / M_i, where M_i is the total
                           mass of bodies 0 to i */
        *mu;            /* [bodies] k2 M_i */
    double *work;       /* [6 * bodies] */
};

/* Returns why the bodies of a scene cannot move along ellipses, or NULL if
   they can. Defined in planetary.c. */
const char *jacobi_refuses(const struct scene *s);

/* Prepares *j for this number of bodies. The pointer mass is kept. Returns
   false, with nothing to free, if memory runs out. */
bool jacobi_create(struct jacobi *j, size_t bodies, const double mass[],
                   double k2);

/* Frees what jacobi_create allocated. */
void jacobi_free(struct jacobi *j);

/* Transforms positions, velocities or accelerations into Jacobi
   coordinates: (9.9, eq:jacobi). The first of these is the centre of mass
   of all bodies. x and q may be the same array. */
void jacobi_enter(const struct jacobi *j, const double x[], double q[]);

/* Converts the Jacobi coordinates q back to Cartesian ones, x. q and x may
   be the same array. */
void jacobi_leave(const struct jacobi *j, const double q[], double x[]);

/* Returns the forces that perturb the ellipses, for stepping_begin: (9.10,
   eq:wisdom-holman). j must outlive the forces. */
struct stepping_forces jacobi_forces(struct jacobi *j);

/* Moves the bodies along their ellipses by the time dt (in s). This is the
   stepping_flow for jacobi_forces, and `what` is the struct jacobi. The
   position of a body on an open orbit becomes NaN. */
void jacobi_flow(void *what, double dt, double x[], double v[]);

#endif
