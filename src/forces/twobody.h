/* Leapfrog for two bodies that attract each other, all in registers. */
#ifndef TWOBODY_H
#define TWOBODY_H

#include "forces/gravity.h"
#include "forces/stepping.h"

#include <stddef.h>
#include <stdint.h>

/* Moves the two bodies of *s by `steps` steps, but for the last half kick,
   as a stepping_sweep does; a[6] are the accelerations before and after.
   Nothing else acts than the pull of *g and a weight of weight[3], m/s^2;
   the `fixed` coordinates whose numbers stand in held[] stay. The bits are
   those of the general loops of stepping.c and gravity.c. */
void twobody_sweep(const struct gravity *g, const struct stepping *s,
                   const double weight[3], const size_t held[],
                   size_t fixed, double a[], uint64_t steps);

#endif
