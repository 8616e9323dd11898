/* The plans of disks_run: the next event of each disk. */
#ifndef PLAN_H
#define PLAN_H

#include "box/disks.h"

/* The next event of each disk, as found when it was planned last. */
struct disks_plan {
    double replan;             /* longest flight before a new plan, m */
    struct disks_event *event; /* next event of each disk */
    uint32_t *hits;            /* partner's collisions at planning */
    double *time;              /* scratch: times of meeting, s */
};

#endif
