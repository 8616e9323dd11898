/* Contacts as stiff springs: forces between bodies that overlap. */
#ifndef TOUCH_H
#define TOUCH_H

#include "forces/spheres.h"

/* The contacts of a scene whose touch is not SCENE_SUDDEN. */
struct touch {
    const struct scene *scene;
    struct spheres *near; /* finds the pairs that overlap; a pointer, since
                             to ask for an energy changes nothing else */
};

/* Prepares for the bodies of a scene, which has to outlive *t. Returns
   false, with nothing to free, without memory. */
bool touch_create(struct touch *t, const struct scene *s);
void touch_free(struct touch *t);

/* Adds to a, m/s^2, the accelerations of bodies at x, m, with velocities v,
   m/s, where they overlap each other or a wall. Source: (11.11, eq:touch).
 */
void touch_add(struct touch *t, const double x[], const double v[],
               double a[]);

/* Returns the energy that all overlaps have stored, J. */
double touch_potential(const struct touch *t, const double x[]);

#endif
