/* Exercise 08a, worked: drift, kick, drift.

   A drift is exact for bodies without forces, a kick for bodies that stand
   still. Half a drift brings the coordinates to the middle of the step,
   where the acceleration is worth more than at either end: that is why the
   order is 2. All coordinates must be there before acceleration() is asked,
   because the force on one depends on where the others are. Then all
   velocities are kicked, and with the NEW velocities the second half of the
   drift follows. Read backwards the step is the same with -dt, so that it
   is reversible to rounding.

   Between two steps half a drift follows half a drift with the same
   velocities. They could be one whole drift, if only the first and the last
   are half ones: a little quicker, and the bits differ. The forces cannot
   be saved that way. The other leapfrog can save them, since the half kick
   at the end of a step and that at the beginning of the next happen at the
   same place; here there is just one kick a step anyway.

   Which is better? On the oscillator both have the same frequency and the
   same limit 2. The kicks take place half-way, at places that nobody ever
   sees: a program that also wants the forces of what it prints, for the
   potential energy or to choose its step, has them at hand in the other
   one, and must ask once more here. */

#include "exercise.h"
#include <stddef.h>

enum { MOST = 60 };

/* In m/s^2. */
void acceleration(const double x[], double a[]);

static void advance(size_t n, double y[], const double rate[], double time)
{
    while (n-- > 0)
        y[n] += time * rate[n];
}

void drift_kick_drift(size_t n, double x[], double v[], double dt,
                      size_t steps)
{
    double a[MOST];
    while (steps-- > 0) {
        advance(n, x, v, 0.5 * dt);
        acceleration(x, a);
        advance(n, v, a, dt);
        advance(n, x, v, 0.5 * dt);
    }
}
