/* Moves disks from tick to tick, by a wrong loop and by a correct loop. */
#ifndef LOOP_H
#define LOOP_H

#include "box/disks.h"

/* A loop over ticks, either that of the article that chapter 5 reviews or a
   corrected one. All disks are at the time t. At an event, t has already
   advanced by a tick. The loop then moves the disks by the time from t to
   the event, which is negative, plus `offset` ticks. The correct offset is
   +1; the article has -1. */
struct loop {
    struct disks d;
    struct disks_event next;
    double t;      /* present time, s */
    double offset; /* ticks; 1 is correct, the article has -1 */
};

/* Carries out the next event, and finds the event after it. */
void loop_event(struct loop *l);

/* Runs one iteration of the article's loop, which makes one record: moves
   the disks to the next tick, `every` s later, or to the next event if this
   is earlier. */
void loop_turn(struct loop *l, double every);

/* Carries out all events up to the time `tick` (in s), and sets the clock
   to it. */
void loop_go_to(struct loop *l, double tick);

/* Returns the deepest overlap (in m) of disks with each other or with the
   walls, in a box with walls on all sides. The error in the article makes
   disks overlap. */
double loop_overlap(const struct loop *l);

#endif
