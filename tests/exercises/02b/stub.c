/* Exercise 02b. A sampler that looks too often (core, 20 minutes)

   Somebody else's program wrote down the path of a ball: an event for each
   collision, with the time, the place and the velocity that the ball has
   from then on. Between two events it flies freely, and after the last one
   it goes on for ever. The sampler below was to say where the ball is at
   each tick of a clock. It does not: it says where the ball collides. Mend
   it.

   Given:
     events   the number of events, at least 1
     path     the events in the order of time. The first is the start and
              has time 0; no two have the same time.
     tick     the time from one tick of the clock to the next, in s
     samples  the number of samples wanted
   To fill in:
     x        the position, in m, at each tick: x[0] after one tick, x[1]
              after two, ... x[samples - 1] after that many ticks; nothing
              for the start. No sample may be further from the true place
              than rounding once each time, velocity and place takes it,
              however many there are.

   Check your answer with    make check EX=02b
   Hints, which ask before they tell:    make hint EX=02b */

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
    /* TODO: mend these lines. They run and look like samples; but where is
       the clock? */
    (void)tick;
    for (size_t k = 0; k < samples; ++k) {
        const size_t event = k + 1 < events ? k + 1 : events - 1;
        x[k] = NOT_DONE_YET(path[event].x);
    }
}
