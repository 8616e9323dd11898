/* Declares the slab engine for the other files of the line. */
#ifndef SLAB_H
#define SLAB_H

#include "line/bonkers.h"

/* Largest number of due gaps of an island that fit into the schedule.
   Larger islands are left to the heap engine. */
enum { SLAB_WAITING = 4096 };

/* Returns the state of the engine, or NULL if memory runs out. */
struct bonkers_slab *slab_create(const struct bonkers *b);

/* Frees the memory of the engine. Does nothing if s is NULL. */
void slab_free(struct bonkers_slab *s);

/* Runs until the time `until`, as bonkers_run does. */
enum bonkers_stop slab_run(struct bonkers *b, double until, uint64_t limit);

#endif
