/* Leapfrog for two bodies that attract each other, in registers. */
#ifndef TWOBODY_H
#define TWOBODY_H

#include "forces/gravity.h"
#include "forces/stepping.h"

#include <stddef.h>
#include <stdint.h>

/* Takes `steps` steps of the two bodies of *s, without the last half kick,
   as a stepping_sweep does. a[6] has the accelerations before the steps,
   and receives those after them. Only the attraction of *g and the uniform
   gravity weight[3] (in m/s^2) act. The `fixed` coordinates listed in
   held[] do not change. All bits equal those from the general loops of
   steps.h and pull.h. */
void twobody_sweep(const struct gravity *g, const struct stepping *s,
                   const double weight[3], const size_t held[],
                   size_t fixed, double a[], uint64_t steps);

#endif
