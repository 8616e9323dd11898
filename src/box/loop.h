/* Disks moved from tick to tick by a wrong loop and by a right one. */
#ifndef LOOP_H
#define LOOP_H

#include "box/disks.h"

/* The loop of the article that chapter 5 reviews, and a right one. All
   disks are at the time t. At an event the article moves them by two ticks
   too little: by the time to the event and `offset` ticks, -1, where +1
   would be right. */
struct loop {
    struct disks d;
    struct disks_event next;
    double t;      /* s */
    double offset; /* ticks */
};

/* Lets the next event happen. */
void loop_event(struct loop *l);

/* One turn of the article's loop, which makes one record: a tick later,
   s, or at the next event. */
void loop_turn(struct loop *l, double every);

/* All events up to the tick, s, and then the tick. */
void loop_go_to(struct loop *l, double tick);

/* Returns how deep disks overlap each other or the walls, m, in a box with
   walls on all sides: what gives the article away. */
double loop_overlap(const struct loop *l);

#endif
