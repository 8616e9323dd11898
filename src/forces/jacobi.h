/* Bodies on ellipses around those before them, perturbed by kicks. */
#ifndef JACOBI_H
#define JACOBI_H

#include "forces/stepping.h"
#include "scenes/scene.h"

#include <stdbool.h>
#include <stddef.h>

/* Bodies in the order of their scene. Coordinate k of body i is element [k
 * bodies + i] of an array. */
struct jacobi {
    size_t bodies;
    double k2;
    const double *mass;    /* [bodies], the caller's; the first is not 0 */
    double *fraction, *mu; /* [bodies] m_i / M_i, k2 M_i; M_i: mass of
                              bodies 0 to i */
    double *work;          /* [6 * bodies] */
};

/* Returns why a scene cannot be stepped along ellipses, because of other
   forces or of its bodies, or NULL if it can. (In planetary.c.) */
const char *jacobi_refuses(const struct scene *s);

/* Prepares for this number of bodies; the pointer mass is kept. Returns
   false, with nothing to free, if memory runs out. */
bool jacobi_create(struct jacobi *j, size_t bodies, const double mass[],
                   double k2);

/* Frees what jacobi_create allocated. */
void jacobi_free(struct jacobi *j);

/* Transform places, velocities or accelerations into Jacobi's coordinates,
   the first of which is the centre of mass of all bodies, and back: (9.9,
   eq:jacobi). x and q may be one array. */
void jacobi_enter(const struct jacobi *j, const double x[], double q[]);
void jacobi_leave(const struct jacobi *j, const double q[], double x[]);

/* Returns the forces that perturb the ellipses, for stepping_begin; j must
   outlive them: (9.10, eq:wisdom-holman). */
struct stepping_forces jacobi_forces(struct jacobi *j);

/* Moves the bodies along their ellipses by the time dt, s: the
   stepping_flow that belongs to jacobi_forces; `what` is the struct jacobi.
   A body on an open orbit gets NaN for its place. */
void jacobi_flow(void *what, double dt, double x[], double v[]);

#endif
