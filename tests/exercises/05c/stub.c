/* Exercise 05c. Mend the clock (core, 30 minutes)

   Somebody else's program runs disks in a box from collision to collision
   and was to record their state at each tick of a clock. It runs, its
   energy is right to the last digits, and its histograms look well. All the
   same it is wrong: collisions take place where nothing touches, the
   pressure on the walls is too low, and the samples are not those of a
   clock. Mend the lines below, which are its whole bookkeeping of time.
   The physics is in good order; the check brings it along, and these four
   functions are all of it that you need.

   Given:
     box      the disks at the time 0
     tick     the time from one tick of the clock to the next, in s
     samples  the number of samples wanted
   To be done: every collision takes place at its time, with the disks where
   they are then. Between two ticks there may be any number of collisions,
   or none; several may fall on one and the same time. The state is recorded
   after 1, 2, ... samples ticks, and at no other time: not at the start and
   not at a collision. The run ends with the last sample.

   To see what an energy check is worth, take NOT_DONE_YET away, leave
   everything else as it is, and run the check: the test of the energy, its
   first one, is the only one that passes.

   Check your answer with    make check EX=05c
   Hints, which ask before they tell:    make hint EX=05c */

#include "exercise.h"
#include <stddef.h>

struct box; /* disks in a box, as they are now */

/* How long it is from now on until the next collision, in s; 0 when it is
   now. This collision is then the one that is due. */
double box_next(struct box *box);

/* All disks fly freely for this time, in s. */
void box_fly(struct box *box, double time);

/* The collision that is due takes place, now. */
void box_collide(struct box *box);

/* Keeps the state as it is now for a sample of the time t, in s. */
void box_record(struct box *box, double t);

void box_run(struct box *box, double tick, size_t samples)
{
    /* TODO: mend these lines. What is t when the disks are moved, and
       where are they then? */
    double t = 0.0, event = box_next(box);
    for (size_t k = 0; k < samples; ++k) {
        t = NOT_DONE_YET(t) + tick;
        if (t < event) {
            box_fly(box, tick);
        } else {
            box_fly(box, event - t - tick);
            box_collide(box);
            t = event;
            event = t + box_next(box);
        }
        box_record(box, t);
    }
}
