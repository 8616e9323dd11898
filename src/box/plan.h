/* What disks_run remembers of each disk. */
#ifndef PLAN_H
#define PLAN_H

#include "box/disks.h"

/* The plans of a run: each disk's next event, as found when it was planned
   last. */
struct disks_plan {
    double replan;             /* how far a plan holds, m */
    struct disks_event *event; /* of each disk */
    uint32_t *hits;            /* of the partner, when it was planned */
    double *time;              /* for answers */
};

#endif
