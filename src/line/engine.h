/* What the engines of the line need of each other, and nobody else. */
#ifndef ENGINE_H
#define ENGINE_H

#include "line/bonkers.h"

/* Returns by how much rounding may misplace bodies i - 1 and i, m. */
double engine_rounding(const struct bonkers *b, size_t i);

/* Nothing more happens before `until`: lets the clock run on, or stops it
   at the last collision if there is no end. */
enum bonkers_stop engine_idle(struct bonkers *b, double until);

/* Puts gap i into the schedule, if it will close, or takes it out. */
void engine_reschedule(struct bonkers *b, size_t i);

/* Runs the engine with a heap, as bonkers_run does. */
enum bonkers_stop engine_run_heap(struct bonkers *b, double until,
                                  uint64_t limit);

#endif
