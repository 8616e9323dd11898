/* Computes the velocities of two bodies after a collision. */
#ifndef COLLIDE_H
#define COLLIDE_H

#include <stdbool.h>
#include <stddef.h>

enum { COLLIDE_DIMENSIONS = 3 }; /* largest number of dimensions */

/* Five forms of the collision formula, which differ only in rounding. Three
   of them give each body a fraction of the change of the relative
   velocity. */
enum collide_form {
    COLLIDE_CM,         /* about the centre of mass (1.4, eq:reverse) */
    COLLIDE_DIFFERENCE, /* fractions by division (1.8, eq:restitution) */
    COLLIDE_IMPULSE,    /* one common impulse (1.10, eq:impulse) */
    COLLIDE_COMPLEMENT, /* smaller fraction = 1 - larger fraction */
    COLLIDE_SMALLER,    /* larger part: the remainder (1.12, eq:smaller) */
    COLLIDE_FORMS       /* number of forms */
};

/* Collides two bodies on a line: replaces their velocities *v1 and *v2 (in
   any common unit) by those after the collision. im1 and im2 are inverse
   masses (in any common unit), 0 for a wall. restitution is from 0
   (sticking) to 1 (elastic). Returns false and changes nothing for two
   walls, for negative inverse masses, and if their sum is not finite.
   Requires velocities below a quarter of DBL_MAX. Does not check that the
   bodies approach each other. Source: equation (1.8, eq:restitution),
   rounded as (1.12, eq:smaller). */
bool collide(double *v1, double *v2, double im1, double im2,
             double restitution);

/* Collides two smooth bodies. `normal` is parallel to the line between
   their centres and has any length except zero. normal, v1 and v2 have
   `dimensions` components, 1 to COLLIDE_DIMENSIONS. Otherwise like collide,
   but also returns false if the normal is zero or not finite. With one
   dimension and normal 1 the results equal those of collide to the last
   bit. Source: equation (1.10, eq:impulse). */
bool collide_along(size_t dimensions, const double normal[], double v1[],
                   double v2[], double im1, double im2, double restitution);

/* The forms' names, in the order of enum collide_form, then NULL. */
extern const char *const collide_form_names[COLLIDE_FORMS + 1];

/* Like collide and collide_along, but use the given form of the formula. */
bool collide_by(enum collide_form form, double *v1, double *v2, double im1,
                double im2, double restitution);
bool collide_along_by(enum collide_form form, size_t dimensions,
                      const double normal[], double v1[], double v2[],
                      double im1, double im2, double restitution);

#endif
