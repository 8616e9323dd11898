/* Exercise 08a. Drift, kick, drift (warm-up, 20 minutes)

   The leapfrog of the book begins and ends each step with half a kick, and
   drifts in between. There is another one: half a drift, a whole kick, and
   half a drift. It is as good, of order 2 and reversible, and needs the
   forces only once in every step: half-way. Write it.

   Given:
     n        the number of coordinates, from 1 to 60
     x, v     the coordinates, in m, and their velocities, in m/s, at the
              beginning
     dt       the step, in s; it may be negative: back in time
     steps    how many of them, which may be 0
   To fill in:
     x, v     the same at the end of the last step: both at the same time

   The forces come from acceleration(), which the check provides. It fills
   in a[0] to a[n - 1] for the coordinates x[0] to x[n - 1], and leaves
   these as they are. It counts how often it is asked, and may be asked
   once a step.

   Check your answer with    make check EX=08a
   Hints, which ask before they tell:    make hint EX=08a */

#include "exercise.h"
#include <stddef.h>

enum { MOST = 60 };

/* In m/s^2. */
void acceleration(const double x[], double a[]);

void drift_kick_drift(size_t n, double x[], double v[], double dt,
                      size_t steps)
{
    /* TODO: replace these lines by your own. Which velocity does the first
       half of the drift have, and which the second? */
    (void)n;
    (void)v;
    (void)steps;
    x[0] = NOT_DONE_YET(dt);
}
