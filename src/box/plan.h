/* Stores the plans of disks_run: the next event of each disk. */
#ifndef PLAN_H
#define PLAN_H

#include "box/disks.h"

struct disks_plan {
    double replan;             /* longest flight before a new plan, m */
    struct disks_event *event; /* next event of each disk */
    uint32_t *hits;            /* collisions of the partner when planned */
    double *time;              /* scratch: times of meetings, s */
};

#endif
