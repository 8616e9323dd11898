/* Forces for tests of steps: FORCES(name) begins a function that puts the
   accelerations at x and v into a; what points to what they depend on. */
#ifndef FORCES_H
#define FORCES_H

#include "unit.h"

#define FORCES(name)                                                       \
    static inline void name(UNUSED void *what, UNUSED const double x[],    \
                            UNUSED const double v[], double a[])

FORCES(orbit)
{
    const double r2 = x[0] * x[0] + x[1] * x[1], r = sqrt(r2);
    a[0] = -x[0] / (r * r2);
    a[1] = -x[1] / (r * r2);
}

#endif
