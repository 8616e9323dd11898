/* Steps of their own length, begun, and freed at the end of their block:
   `OWN a = begun("radau15", forces, tolerance, first step, x, v);` */
#ifndef OWN_STEPS_H
#define OWN_STEPS_H

#include "library/forces.h"
#include "forces/adaptive.h"

#define OWN __attribute__((cleanup(end_own))) struct adaptive *const

static inline void end_own(struct adaptive *const *a)
{
    adaptive_free(*a);
}

static inline struct adaptive *begun(const char *name,
                                     struct stepping_forces f,
                                     double tolerance, double first,
                                     const double x[], const double v[])
{
    struct adaptive *const a = adaptive_create(stepping_find(name), f);
    UNIT_MUST(a);
    adaptive_begin(a, tolerance, first, 0, x, v);
    return a;
}

static const struct stepping_forces orbit_forces = {2, false, orbit, NULL};

#endif
