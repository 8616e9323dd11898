/* An adaptive method of the GNU Scientific Library, for comparison. */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "forces/stepping.h"

/* An external adaptive method: rk8pd of the GNU Scientific Library, Prince
   and Dormand's Runge-Kutta pair of order 8. */
struct reference {
    struct stepping_forces forces;
    double tolerance;
    uint64_t evaluations;
    struct reference_parts *parts;
};

/* Whether this program was built with the library. */
extern const bool reference_available;

/* Prepares r. In each step the method keeps the error of every coordinate
   below `tolerance` times the largest coordinate when reference_step is
   called, and likewise for velocities. Returns false if memory runs out or
   the library is missing. Prevents the library from ending the program on
   errors. */
bool reference_begin(struct reference *r, struct stepping_forces f,
                     double tolerance);

/* Moves x and v by the time dt (in s), in as many steps as needed. Earlier
   calls have no influence. Returns false if the library fails or a million
   steps are not enough. */
bool reference_step(struct reference *r, double dt, double x[], double v[]);

void reference_free(struct reference *r);

#endif
