/* What gravity changes for the engines of the line, and only for them. */
#ifndef WEIGHT_H
#define WEIGHT_H

#include "line/bonkers.h"

/* Returns body i as it is at the time t, if it meets nobody until then
   (5.12, eq:fall). */
struct bonkers_body weight_body_at(const struct bonkers *b, size_t i,
                                   double t);

/* Returns when gap i closes, s; INFINITY: never. */
double weight_time_of_gap(const struct bonkers *b, size_t i);

/* Collides the bodies of gap i at the time it is due, as collide_gap does.
 */
bool weight_collide_gap(struct bonkers *b, size_t i);

/* Runs the naive engine, as bonkers_run does. */
enum bonkers_stop weight_run_naive(struct bonkers *b, double until,
                                   uint64_t limit);

#endif
