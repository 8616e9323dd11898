/* Velocities of two bodies after a collision. */
#ifndef COLLIDE_H
#define COLLIDE_H

#include <stdbool.h>
#include <stddef.h>

enum { COLLIDE_DIMENSIONS = 3 }; /* largest number of dimensions */

/* Five forms of the formula; they differ only by rounding. */
enum collide_form {
    COLLIDE_CM,         /* reverse about the centre (1.4, eq:reverse) */
    COLLIDE_DIFFERENCE, /* two fractions, divided (1.8, eq:restitution) */
    COLLIDE_IMPULSE,    /* one impulse for both (1.10, eq:impulse) */
    COLLIDE_COMPLEMENT, /* smaller fraction as 1 - larger */
    COLLIDE_SMALLER,    /* smaller, and the rest (1.12, eq:smaller) */
    COLLIDE_FORMS       /* number of forms */
};

/* Collides two bodies on a line: replaces their velocities *v1, *v2 (in any
   common unit) by those after the collision. im1, im2: inverse masses (in
   any common unit), 0 for a wall; restitution: from 1, elastic, to 0,
   sticking. Returns false, with nothing changed, if the result is
   undefined: for two walls, or inverse masses that are negative or whose
   sum is not finite. Requires velocities below a quarter of DBL_MAX. Does
   not check that the bodies approach. Source: equation (1.8,
   eq:restitution), rounded as (1.12, eq:smaller). */
bool collide(double *v1, double *v2, double im1, double im2,
             double restitution);

/* Collides two smooth bodies; normal is a vector of any length but zero
   along the line between their centres. normal, v1, v2: arrays of
   `dimensions` numbers, 1 to COLLIDE_DIMENSIONS. Otherwise as collide, but
   returns false also if the normal is zero or not finite. With one
   dimension and normal 1 the results of both functions are equal to the
   last bit. Source: equation (1.10, eq:impulse). */
bool collide_along(size_t dimensions, const double normal[], double v1[],
                   double v2[], double im1, double im2, double restitution);

/* The forms' names, in the order of enum collide_form, then NULL. */
extern const char *const collide_form_names[COLLIDE_FORMS + 1];

/* Do what collide and collide_along do, in a chosen form, to compare. */
bool collide_by(enum collide_form form, double *v1, double *v2, double im1,
                double im2, double restitution);
bool collide_along_by(enum collide_form form, size_t dimensions,
                      const double normal[], double v1[], double v2[],
                      double im1, double im2, double restitution);

#endif
