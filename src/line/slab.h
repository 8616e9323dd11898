/* The engine with slabs. For bonkers.c only. */
#ifndef SLAB_H
#define SLAB_H

#include "line/bonkers.h"

/* How many gaps of one island may wait in the schedule; more are left to
   the heap engine. */
enum { SLAB_WAITING = 4096 };

/* Returns what the engine keeps, or NULL when there is no memory. */
struct bonkers_slab *slab_create(const struct bonkers *b);

/* Frees the engine's memory; does nothing if s is NULL. */
void slab_free(struct bonkers_slab *s);

/* Runs until the time `until`, as bonkers_run does. */
enum bonkers_stop slab_run(struct bonkers *b, double until, uint64_t limit);

#endif
