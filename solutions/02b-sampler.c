/* Exercise 02b, worked: a sampler that looks too often.

   The clock leads and the path follows. For each tick we take the time
   first; then we let events go by as long as the next one is not later than
   that; then the ball flies freely from the last event that has passed,
   with the velocity which it has since. No event, one or many may go by
   between two ticks, so the inner loop is a while and not an if.

   An event counts as passed when it falls exactly on a tick; that is a
   matter of taste, as the place is the same from both sides. It would be
   none if the velocity were sampled.

   The time is the product k * tick, rounded once. The sum tick + tick + ...
   is rounded at each step, for a long while in the same direction: after
   100000 ticks of 0.1 s it is wrong by 2e-8 s, after a million by more than
   1e-6 s, and the ball is then somewhere else.

   Another way: find, by bisection, the first event after each tick, and
   draw the straight line through the places of the events on both sides. Or
   go through the flights and, for each, through the ticks that fall into
   it. */

#include "exercise.h"
#include <stddef.h>

struct event {
    double t; /* time, in s */
    double x; /* position, in m */
    double v; /* velocity from now on, in m/s */
};

void sample(size_t events, const struct event path[], double tick,
            size_t samples, double x[])
{
    const struct event *last = path, *const end = path + events;
    for (size_t k = 1; k <= samples; ++k) {
        const double now = (double)k * tick;
        while (last + 1 < end && last[1].t <= now)
            ++last;
        x[k - 1] = last->x + last->v * (now - last->t);
    }
}
