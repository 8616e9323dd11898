/* Functions that the engines of the line share; private to them. */
#ifndef ENGINE_H
#define ENGINE_H

#include "line/bonkers.h"

/* Returns the largest expected rounding error (in m) of the distance
   between bodies i - 1 and i. */
double engine_rounding(const struct bonkers *b, size_t i);

/* Ends a run in which nothing happens before `until`: sets the clock to
   that time or, if it is infinite, to the time of the last collision. */
enum bonkers_stop engine_idle(struct bonkers *b, double until);

/* Puts gap i into the schedule if it will close. Otherwise removes it. */
void engine_reschedule(struct bonkers *b, size_t i);

/* Runs the engine with a heap, as bonkers_run does. */
enum bonkers_stop engine_run_heap(struct bonkers *b, double until,
                                  uint64_t limit);

#endif
