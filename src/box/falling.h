/* What gravity changes for disks; called only where there is some. */
#ifndef FALLING_H
#define FALLING_H

#include "box/disks.h"

#include <math.h>

/* Adds to a place and to a velocity, or NULL, that were moved as if there
   were no gravity, what it changes in a while (5.12, eq:fall). */
static inline void falling_move(const struct disks *d, double wait,
                                double place[], double velocity[])
{
    place[1] -= d->gravity * wait / 2 * wait;
    if (velocity)
        velocity[1] -= d->gravity * wait;
}

/* Adds what gravity changes in the separation x from disk a to disk b, and
   in its rate of change v, up to the later of their times. Both fall alike,
   so it is the time by which one is remembered earlier that counts. */
static inline void falling_between(const struct disks *d,
                                   const struct disk *a,
                                   const struct disk *b, double x[],
                                   double v[])
{
    const double ahead = b->since - a->since, wait = fabs(ahead);
    const double lag = ahead > 0 ? d->gravity * wait : -d->gravity * wait;
    v[1] += lag;
    x[1] += lag / 2 * wait;
}

/* Returns how long disk a flies from its last collision until it is at the
   floor or at the roof, s. */
double falling_wall(const struct disks *d, const struct disk *a);

/* Moves disk a to the floor or the roof, where it is now. */
void falling_land(const struct disks *d, struct disk *a);

/* Returns the potential energy, J: 0 with all disks on the floor. */
double falling_energy(const struct disks *d);

#endif
