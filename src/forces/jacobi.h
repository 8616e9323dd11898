/* Bodies that go along ellipses about those before them, and are kicked. */
#ifndef JACOBI_H
#define JACOBI_H

#include "forces/stepping.h"
#include "scenes/scene.h"

#include <stdbool.h>
#include <stddef.h>

/* Bodies in the order of their scene. Coordinate k of body i stands at
   [k * bodies + i]. */
struct jacobi {
    size_t bodies;
    double k2;
    const double *mass;    /* [bodies], of the caller; the first not 0 */
    double *fraction, *mu; /* [bodies] m_i / M_i and k2 M_i, where M_i is
                           the mass of bodies 0 to i */
    double *work;          /* [6 * bodies] */
};

/* Returns NULL, or why a scene cannot be stepped along ellipses: what else
   is in it, or what is wrong with its bodies. (In planetary.c.) */
const char *jacobi_refuses(const struct scene *s);

/* Prepares for this number of bodies; the pointer mass is kept. Returns
   false, with nothing to free, when there is no memory. */
bool jacobi_create(struct jacobi *j, size_t bodies, const double mass[],
                   double k2);

/* Frees what jacobi_create took. */
void jacobi_free(struct jacobi *j);

/* Turn places, velocities or accelerations into Jacobi's coordinates, of
   which the first is that of the centre of mass of all bodies, and back:
   (9.9, eq:jacobi). x and q may be the same array. */
void jacobi_enter(const struct jacobi *j, const double x[], double q[]);
void jacobi_leave(const struct jacobi *j, const double q[], double x[]);

/* Returns what disturbs the ellipses as forces for stepping_begin; j must
   outlive them: (9.10, eq:wisdom-holman). */
struct stepping_forces jacobi_forces(struct jacobi *j);

/* Moves the bodies along their ellipses by the time dt: the flow of the
   stepping that has these forces; `what` is the struct jacobi. A body on an
   open orbit gets NaN for its place. */
void jacobi_flow(void *what, double dt, double x[], double v[]);

#endif
