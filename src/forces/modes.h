/* Frequencies and shapes of the small oscillations of a scene. */
#ifndef MODES_H
#define MODES_H

#include "forces/springs.h"

/* The small oscillations of a scene of springs about an equilibrium. */
struct modes {
    size_t size;        /* number of free coordinates, and of modes */
    size_t *coordinate; /* [size] free coordinates, ascending */
    double *square;     /* [size] of the angular frequencies, 1/s^2,
                           ascending; negative: unstable */
    double *shape;      /* mode j from [j * size] on: displacements times
                           the root of the mass, normalised to length 1 */
    double *weight;     /* [size] inverse mass, 1/kg */
};

/* Finds the modes about x, from the springs alone, without dashpots. The
   time grows as size^3. Returns false, with nothing to free, if memory runs
   out. Source: (10.10, eq:spring-stiffness). */
bool modes_find(struct modes *m, const struct springs *p, const double x[]);

/* Frees the modes and makes *m empty. */
void modes_free(struct modes *m);

/* Writes the static displacements of the bodies, m, due to accelerations a,
   m/s^2, in linear theory, into u; u and a are arranged as x. Modes whose
   square is below least are left out. */
void modes_deflection(const struct modes *m, double least, const double a[],
                      double u[]);

#endif
