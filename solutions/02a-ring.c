/* Exercise 02a, worked: the next collision on a ring.

   A pair is a bead and its right neighbour, so there are as many pairs as
   beads. The seam needs no loop of its own: walk round the ring from the
   last bead down and remember the neighbour you have come from. For the
   last bead that is bead 0, one length of the ring further on.

   Whether two beads meet is a matter of their velocities alone: the left
   one must be the faster. That test comes first. It keeps the beads apart
   that touch and part, such as two that have just collided, and no division
   by zero is left. When they meet is a matter of the gap; one that rounding
   has made negative counts as zero, or time would run backwards.

   Going down with <= in place of < gives the tie to the smaller number.
   With one bead the neighbour is the bead itself, which is not faster than
   itself; with two beads there are two pairs, one for each way round.

   Another way: (i + 1) % n for the right neighbour, and the length added
   where that is 0; or a copy of bead 0 behind the last one, at x[0] +
   length, and then a wire with ends. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

double next_meeting(size_t n, double length, const double x[],
                    const double v[], size_t *left)
{
    double soonest = INFINITY;
    double ahead = x[0] + length; /* where the right neighbour is */
    double flees = v[0];          /* and its velocity */
    for (size_t i = n; i-- > 0; ahead = x[i], flees = v[i]) {
        if (v[i] <= flees)
            continue;
        const double wait = fmax(0.0, ahead - x[i]) / (v[i] - flees);
        if (wait <= soonest) {
            soonest = wait;
            *left = i;
        }
    }
    return soonest;
}
