/* Keeps verdicts until something that they depend on changes. */
#ifndef MEMORY_H
#define MEMORY_H

#include "examiner/course.h"

#include <stdint.h>

/* Returns a checksum of all that a verdict on the student's file depends
   on, or 0 if the file includes others of his, which are not followed. */
uint64_t memory_key(const struct exercise *e, bool strict, int seconds);

/* Fills in the state of an exercise from the kept verdict; returns false,
   with nothing changed, when there is none with this key. */
bool memory_recall(struct exercise *e, uint64_t key);

/* Keeps the state of an exercise. Nothing depends on whether that works. */
void memory_keep(const struct exercise *e, uint64_t key);

#endif
