/* What one may look at in a motion, by name: energies, places, speeds. */
#ifndef OBSERVABLES_H
#define OBSERVABLES_H

#include "forces/motion.h"
#include "toolbox/table.h"

enum { OBSERVABLES_MOST = 64, OBSERVABLES_MESSAGE = 160 };

/* What is looked at: a kind, and the bodies it is asked of. */
struct observable {
    const struct observables_kind *kind;
    size_t body[2];
};

/* A list of them, and how many columns they have in all. */
struct observables {
    struct observable list[OBSERVABLES_MOST];
    size_t count, columns;
};

/* Reads names with commas between them, as in "energy,z:30". On failure
   returns false and says why in message. */
bool observables_read(struct observables *o, const char *text,
                      size_t bodies, char message[OBSERVABLES_MESSAGE]);

/* Its columns, their unit, and the axis along which it is a coordinate of a
   body, from 0 on; 3: it is none. */
struct observables_sort {
    size_t width, axis;
    const char *unit;
};
struct observables_sort observables_sort(const struct observable *o);

/* Adds a line to the head of a table for each column. */
void observables_head(const struct observables *o, struct table *t);

/* Writes the numbers now, o->columns of them. Units are those of the
   scene: length, time, mass. */
void observables_values(const struct observables *o, const struct motion *m,
                        double values[]);

/* Adds the lines, or writes the numbers, for the states of n bodies, six
   columns for each. States have no name among the observables: a table
   without observables has those of all bodies. */
void observables_head_states(struct table *t, size_t n,
                             const size_t body[]);
void observables_states(const struct motion *m, size_t n,
                        const size_t body[], double values[]);

/* Returns the name of kind k, NULL if there are fewer kinds. Sets *bodies
   to the number of bodies in its arguments. */
const char *observables_name(size_t k, size_t *bodies);

#endif
