/* An adaptive method from outside, with which our own are compared. */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "forces/stepping.h"

/* A method with variable steps, from outside: rk8pd of the GNU Scientific
   Library, Prince and Dormand's Runge-Kutta pair of order 8. */
struct reference {
    struct stepping_forces forces;
    double tolerance;
    uint64_t evaluations;
    struct reference_parts *parts;
};

/* Says whether this program was built with the library. */
extern const bool reference_available;

/* Prepares r; in each of its steps the error of a coordinate is kept below
   `tolerance` times the largest one, that of a velocity likewise, as they
   are when reference_step is called. Returns false if memory runs out, or
   if there is no library. Turns off the library's habit of ending the
   program. */
bool reference_begin(struct reference *r, struct stepping_forces f,
                     double tolerance);

/* Takes x and v as far as dt, s, in as many steps as that needs; nothing
   is kept from one call to the next. False: the library gave up, or a
   million steps were not enough. */
bool reference_step(struct reference *r, double dt, double x[], double v[]);

void reference_free(struct reference *r);

#endif
