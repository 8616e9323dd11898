/* Stores the verdict on each exercise until one of its inputs changes. */
#ifndef CACHE_H
#define CACHE_H

#include "examiner/course.h"

#include <stdint.h>

/* Returns a checksum of everything that the verdict on e->file depends on.
   Returns 0 if e->file includes other files of the student: the checksum
   does not cover them, so the verdict cannot be stored. */
uint64_t cache_key(const struct exercise *e, bool strict, int seconds);

/* Fills in the state of e from its stored verdict. Returns false and leaves
   e unchanged if no verdict with this key is stored. */
bool cache_load(struct exercise *e, uint64_t key);

/* Stores the state of e under this key. Ignores failures, which only cost
   time. */
void cache_save(const struct exercise *e, uint64_t key);

#endif
