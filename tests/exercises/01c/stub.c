/* Exercise 01c. A stack of balls is dropped (core, 25 minutes)

   Balls are held one above the other, with hardly any space between them,
   and dropped together on a hard floor. All of them arrive with the same
   speed. The lowest meets the floor first and comes back; then it meets
   the second, which meets the third, and so on: one collision after the
   other, from the floor up, each over before the next begins. With what
   velocity does the top ball leave?

   Given:
     n            the number of balls, at least 1
     masses       masses[0] of the lowest ball to masses[n - 1] of the top
                  one, in kg, all greater than zero
     speed        the speed at which all of them arrive, in m/s
     restitution  of every impact, the one on the floor included: 0 to 1
   Returns the velocity of the top ball just after it has been hit, in m/s,
   positive upwards. It is negative when the top ball goes on falling.

   Check your answer with    make check EX=01c
   Hints, which ask before they tell:    make hint EX=01c */

#include "exercise.h"
#include <stddef.h>

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution)
{
    /* TODO: replace these lines by your own. Follow the blow from the floor
       up. What does each ball know of those below it? */
    (void)n;
    (void)masses;
    (void)restitution;
    return NOT_DONE_YET(speed);
}
