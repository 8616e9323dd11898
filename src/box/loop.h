/* From chapters/works/05-disks.nw: edit there, then run make tangle. */
/* checksum 1381519620 of the lines below */
/* Disks moved from tick to tick: the article's loop, and a right one. */
#ifndef LOOP_H
#define LOOP_H

#include "box/disks.h"

/* All disks are at the time t. */
struct loop {
    struct disks d;
    struct disks_event next;
    double t, slip; /* s; -1 as in the article, +1 as it should be */
};

/* Lets the next event happen. */
void loop_event(struct loop *l);

/* One turn of the article's loop, which makes one record: a tick later,
   s, or at the next event. */
void loop_turn(struct loop *l, double every);

/* All events up to the tick, s, and then the tick. */
void loop_go_to(struct loop *l, double tick);

/* How deep disks are in each other, or in the walls of a box of hard
   walls, m; 0: not at all. */
double loop_overlap(const struct loop *l);

#endif
