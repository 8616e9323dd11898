/* Observables of a motion, by name: energies, positions, speeds. */
#ifndef OBSERVABLES_H
#define OBSERVABLES_H

#include "forces/motion.h"
#include "toolbox/table.h"

enum { OBSERVABLES_MOST = 64, OBSERVABLES_MESSAGE = 160 };

/* An observable: its kind, and the numbers of its bodies. */
struct observable {
    const struct observables_kind *kind;
    size_t body[2];
};

/* A list of observables, and their total number of columns. */
struct observables {
    struct observable list[OBSERVABLES_MOST];
    size_t count, columns;
};

/* Reads names separated by commas, as in "energy,z:30". On failure returns
   false and writes an error into message. */
bool observables_read(struct observables *o, const char *text,
                      size_t bodies, char message[OBSERVABLES_MESSAGE]);

/* The number of columns of an observable and their unit. If the observable
   is a coordinate of a body, axis is 0 to 2, otherwise 3. */
struct observables_sort {
    size_t width, axis;
    const char *unit;
};
struct observables_sort observables_sort(const struct observable *o);

/* Adds a line to the head of a table for each column. */
void observables_head(const struct observables *o, struct table *t);

/* Writes the current values of all observables, o->columns numbers, in the
   scene's units of length, time and mass. */
void observables_values(const struct observables *o, const struct motion *m,
                        double values[]);

/* observables_head_states adds the lines of the head for the positions and
   velocities of n bodies, six columns for each body. If body is NULL, these
   are the bodies 0 to n - 1. observables_states writes their values. A
   table without observables has these columns for all bodies. */
void observables_head_states(struct table *t, size_t n,
                             const size_t body[]);
void observables_states(const struct motion *m, size_t n,
                        const size_t body[], double values[]);

/* Returns the name of kind k, or NULL if there is none. Sets *bodies to the
   number of bodies in its arguments. */
const char *observables_name(size_t k, size_t *bodies);

#endif
