/* Contacts as stiff springs: forces between overlapping bodies. */
#ifndef SOFT_H
#define SOFT_H

#include "forces/spheres.h"

/* The contacts of a scene whose law is not SCENE_SUDDEN. */
struct soft {
    const struct scene *scene;
    struct spheres *near; /* finds overlapping pairs; a pointer, so that
                             soft_potential can change it although *t is
                             const */
};

/* Prepares *t for the bodies of a scene, which must outlive *t. Returns
   false, with nothing to free, if memory runs out. */
bool soft_create(struct soft *t, const struct scene *s);
void soft_free(struct soft *t);

/* Adds to a[] the accelerations (in m/s^2) of bodies that overlap each
   other or a wall: (11.11, eq:touch). The positions x are in m, the
   velocities v in m/s. */
void soft_add(struct soft *t, const double x[], const double v[],
              double a[]);

/* Returns the elastic energy of all overlaps, J. */
double soft_potential(const struct soft *t, const double x[]);

#endif
