/* Frequencies and shapes of the small oscillations of a scene. */
#ifndef MODES_H
#define MODES_H

#include "forces/springs.h"

/* The small oscillations of a scene of springs round a place of rest. */
struct modes {
    size_t size;        /* free coordinates, and modes */
    size_t *coordinate; /* [size] which they are, rising */
    double *square;     /* [size] of the angular frequencies, 1/s^2, rising;
                           below 0: not stable */
    double *shape;      /* mode j is at [j * size]: displacements times the
                           root of the mass, of length 1 */
    double *weight;     /* [size] 1/m, 1/kg */
};

/* Finds the modes round x, from the springs alone: no dashpots. The time
   that it takes grows as size^3. Returns false, with nothing to free, if
   memory runs out. Source: (10.10, eq:spring-stiffness). */
bool modes_find(struct modes *m, const struct springs *p, const double x[]);

/* Frees the modes and makes *m empty. */
void modes_free(struct modes *m);

/* Writes by how much the bodies give way, m, to the accelerations a, m/s^2,
   in linear theory; both lie as x does. Modes whose square is below least
   are left out. */
void modes_deflection(const struct modes *m, double least, const double a[],
                      double u[]);

#endif
