/* Verdicts that are remembered until something changes. */
#ifndef MEMORY_H
#define MEMORY_H

#include "examiner/course.h"

#include <stdint.h>

/* The key of a verdict on the student's file as it is now, or 0 when no
   key can vouch for it, since the file includes others of his. */
uint64_t memory_key(const struct exercise *e, bool strict, int seconds);

/* Takes how the exercise stands from the remembered verdict; returns
   false, with nothing changed, when there is none of this key. */
bool memory_recall(struct exercise *e, uint64_t key);

/* Remembers how the exercise stands. A failure to do so is no matter. */
void memory_keep(const struct exercise *e, uint64_t key);

#endif
