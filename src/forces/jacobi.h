/* From chapters/works/09-gravity.nw: edit there, then run make tangle. */
/* checksum 4279540695 of the lines below */
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
    const double *mass; /* [bodies], of the caller; the first not 0 */
    double *share, *mu; /* [bodies] m_i / M_i and k2 M_i */
    double *work;       /* [6 * bodies] */
};

/* NULL, or why a scene cannot be stepped along ellipses: what else is in
   it, or what is wrong with its bodies. */
const char *jacobi_refuses(const struct scene *s);

/* Prepares so many bodies; mass is kept, not copied. Returns false, with
   nothing to free, when there is no memory. */
bool jacobi_create(struct jacobi *j, size_t bodies, const double mass[],
                   double k2);

/* Frees what jacobi_create took. */
void jacobi_free(struct jacobi *j);

/* Writes Jacobi's coordinates of places or velocities, that of all first;
   and back again. x and q may be the same. Source: (9.9, eq:jacobi). */
void jacobi_enter(const struct jacobi *j, const double x[], double q[]);
void jacobi_leave(const struct jacobi *j, const double q[], double x[]);

/* What disturbs the ellipses, for stepping_begin; j must outlive them.
   Source: (9.10, eq:wisdom-holman). */
struct stepping_forces jacobi_forces(struct jacobi *j);

/* The ellipses, for the flow of the stepping that has these forces: what is
   the jacobi. A body that has left for ever gets NaN for its place. */
void jacobi_flow(void *what, double dt, double x[], double v[]);

#endif
