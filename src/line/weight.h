/* Declares gravity for the engines of the line. */
#ifndef WEIGHT_H
#define WEIGHT_H

#include "line/bonkers.h"

/* Returns the state of body i at the time t under gravity, if the body does
   not collide before then (5.12, eq:fall). */
struct bonkers_body weight_body_at(const struct bonkers *b, size_t i,
                                   double t);

/* Returns the time (in s) at which gap i closes, or INFINITY if it never
   does. */
double weight_time_of_gap(const struct bonkers *b, size_t i);

/* Collides the bodies of gap i when it closes, as collide_gap does. */
bool weight_collide_gap(struct bonkers *b, size_t i);

/* Runs the naive engine under gravity, as bonkers_run does. */
enum bonkers_stop weight_run_naive(struct bonkers *b, double until,
                                   uint64_t limit);

#endif
