/* Stores states of disks in a file, from which a run continues exactly. */
#ifndef STATES_H
#define STATES_H

#include "box/disks.h"
#include "toolbox/table.h"

enum { STATES_MESSAGE = 256 };

/* The names of the boundaries in the head line of a file of states, then
   NULL. */
extern const char *const states_boundaries[DISKS_BOUNDARIES + 1];

/* Write the head of a file of states, and a block of states. */
void states_begin(struct table *out, const struct disks *d);
void states_write(struct table *out, const struct disks *d);

/* Creates the disks of the last block of a file, at its time. The sides of
   the box are 0 if the head contains none. If the file cannot be read,
   writes the file, line and reason to message and returns false, with
   nothing to free. Does not check that the disks fit. */
bool states_read(struct disks *d, const char *path,
                 char message[STATES_MESSAGE]);

#endif
