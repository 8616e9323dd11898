/* From chapters/works/07-gas.nw: edit there, then run make tangle. */
/* checksum 1084304099 of the lines below */
/* States of disks in a file, from which a run goes on to the last bit. */
#ifndef STATES_H
#define STATES_H

#include "box/disks.h"
#include "toolbox/table.h"

enum { STATES_MESSAGE = 256 };

extern const char *const states_boundaries[DISKS_BOUNDARIES + 1];

/* Writes the head of a file of states, and a block of it. */
void states_begin(struct table *out, const struct disks *d);
void states_write(struct table *out, const struct disks *d);

/* Makes the disks of the last block of a file, at its time; with a box of
   sides 0 when the head names none. Returns false, with nothing to free
   and with the file, line and reason in message, when that cannot be. Does
   not ask whether they fit. */
bool states_read(struct disks *d, const char *path,
                 char message[STATES_MESSAGE]);

#endif
