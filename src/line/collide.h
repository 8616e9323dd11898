/* What becomes of the velocities of two bodies that collide. */
#ifndef COLLIDE_H
#define COLLIDE_H

#include <stdbool.h>
#include <stddef.h>

enum { COLLIDE_DIMENSIONS = 3 }; /* the most that collide_along takes */

/* Ways to write the formula; equal on paper, not in rounding. */
enum collide_form {
    COLLIDE_CM,         /* reverse about the centre (1.4, eq:reverse) */
    COLLIDE_DIFFERENCE, /* two fractions, divided (1.8, eq:restitution) */
    COLLIDE_IMPULSE,    /* one impulse for both (1.10, eq:impulse) */
    COLLIDE_COMPLEMENT, /* the smaller fraction as 1 - larger */
    COLLIDE_SMALLER,    /* the smaller and the rest (1.12, eq:smaller) */
    COLLIDE_FORMS       /* how many there are */
};

/* Collides two bodies on a line: replaces their velocities *v1, *v2 (any
   one unit) by those after the collision. im1, im2: inverse masses (any
   one unit), 0 for a wall; restitution: 1 elastic to 0 sticking. Returns
   true, or false with nothing changed when the collision has no answer:
   two walls, or inverse masses that are negative or whose sum is not
   finite. Requires velocities below a quarter of DBL_MAX.
   Whether the bodies approach is the caller's question.
   Source: equation (1.8, eq:restitution), rounded as (1.12, eq:smaller). */
bool collide(double *v1, double *v2, double im1, double im2,
             double restitution);

/* Collides two smooth bodies whose centres are joined by normal, a vector
   of any length but zero. normal, v1, v2: arrays of `dimensions` numbers,
   1 to COLLIDE_DIMENSIONS; the velocities are replaced. Otherwise as
   collide: false also when the normal is zero or not finite.
   In one dimension with normal 1 the two agree bit for bit.
   Source: equation (1.10, eq:impulse). */
bool collide_along(size_t dimensions, const double normal[], double v1[],
                   double v2[], double im1, double im2, double restitution);

/* The forms' names, in the order of enum collide_form, then NULL. */
extern const char *const collide_form_names[COLLIDE_FORMS + 1];

/* collide and collide_along in a chosen form, for comparison. */
bool collide_by(enum collide_form form, double *v1, double *v2, double im1,
                double im2, double restitution);
bool collide_along_by(enum collide_form form, size_t dimensions,
                      const double normal[], double v1[], double v2[],
                      double im1, double im2, double restitution);

#endif
