/* Stores verdicts, which are valid until an input of theirs changes. */
#ifndef CACHE_H
#define CACHE_H

#include "examiner/course.h"

#include <stdint.h>

/* Returns a checksum of everything that a verdict on the student's file
   depends on. Returns 0 if the file includes other files of the student,
   which are not read: then the verdict cannot be stored. */
uint64_t cache_key(const struct exercise *e, bool strict, int seconds);

/* Fills in the state of an exercise from its stored verdict. Returns
   false, with nothing changed, if there is none with this key. */
bool cache_load(struct exercise *e, uint64_t key);

/* Stores the state of an exercise. If that fails, only time is lost. */
void cache_save(const struct exercise *e, uint64_t key);

#endif
