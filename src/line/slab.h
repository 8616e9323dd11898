/* The engine with slabs; for use by bonkers.c only. */
#ifndef SLAB_H
#define SLAB_H

#include "line/bonkers.h"

/* How many due gaps of one island the schedule can contain; longer islands
   are left to the heap engine. */
enum { SLAB_WAITING = 4096 };

/* Returns the state of the engine, or NULL if memory runs out. */
struct bonkers_slab *slab_create(const struct bonkers *b);

/* Frees the engine's memory; does nothing if s is NULL. */
void slab_free(struct bonkers_slab *s);

/* Runs until the time `until`, as bonkers_run does. */
enum bonkers_stop slab_run(struct bonkers *b, double until, uint64_t limit);

#endif
