/* Frequencies and shapes of the small oscillations of a scene. */
#ifndef MODES_H
#define MODES_H

#include "forces/springs.h"

/* The small oscillations of a scene of springs about an equilibrium. */
struct modes {
    size_t size;        /* number of free coordinates and of modes */
    size_t *coordinate; /* [size] numbers of the free coordinates,
                           ascending */
    double *square;     /* [size] squared angular frequencies, 1/s^2,
                           ascending; negative if unstable */
    double *shape;      /* [size * size] mode j begins at j * size:
                           displacements times the square root of the mass,
                           normalised to length 1 */
    double *weight;     /* [size] inverse masses of the coordinates, 1/kg */
};

/* Finds the modes about the equilibrium x: (10.10, eq:spring-stiffness).
   Takes only springs into account, without dashpots. The computing time
   grows as size^3. Returns false, with nothing to free, if memory runs
   out. */
bool modes_find(struct modes *m, const struct springs *p, const double x[]);

/* Frees the modes and makes *m empty. */
void modes_free(struct modes *m);

/* Computes the static displacements u (in m) due to the accelerations a
   (in m/s^2) in linear theory. Omits modes whose squared frequency is
   below `least`. u and a are arranged like x in modes_find. */
void modes_deflection(const struct modes *m, double least, const double a[],
                      double u[]);

#endif
