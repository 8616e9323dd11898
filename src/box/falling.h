/* Gravity for disks in a box; called only where gravity is not 0. */
#ifndef FALLING_H
#define FALLING_H

#include "box/disks.h"

#include <math.h>

/* Adds the effect of gravity (5.12, eq:fall) to a position (in m)
   and a velocity (in m/s) after a straight flight for the time `wait` (in
   s). `velocity` may be NULL. */
static inline void falling_move(const struct disks *d, double wait,
                                double place[], double velocity[])
{
    place[1] -= d->gravity * wait / 2 * wait;
    if (velocity)
        velocity[1] -= d->gravity * wait;
}

/* Adds the effect of gravity to the separation x (in m) from disk a to disk
   b, and to its rate of change v (in m/s), at the later of the two times
   `since`. Both disks fall alike, so only the difference between these
   times matters. */
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

/* Returns the time (in s) from the last collision of disk a until it
   reaches the floor or the roof. */
double falling_wall(const struct disks *d, const struct disk *a);

/* Moves disk a to the floor or the roof, which it reaches at d->now. */
void falling_land(const struct disks *d, struct disk *a);

/* Returns the potential energy, J. It is 0 with all disks on the floor. */
double falling_energy(const struct disks *d);

#endif
