/* Computes the times at which a disk meets all others, for disks_run. */
#ifndef MEETINGS_H
#define MEETINGS_H

#include "box/disks.h"

/* Fills time[j] with the time (in s) when disk i meets disk j, for all j
   except i. The times equal disks_meeting(d, i, j, d->now) to the last
   bit. */
void meetings_of(const struct disks *d, size_t i, double time[]);

#endif
