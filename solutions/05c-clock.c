/* Exercise 05c, worked: mend the clock.

   There were three faults, and only the first one is a slip of the pen.

   The clock t had been set forward by a tick before the test, the disks had
   not. The way from where they were to the collision took event - (t -
   tick). Without the parentheses it is event - t - tick: two ticks less,
   which is never more than 0. At each collision the disks went back instead
   of forward, and collided in mid-air. A velocity that is reversed, or a
   component that is exchanged, has the same energy wherever that is done:
   so the energy was right to the last digit, and says nothing about time.

   The state was recorded at the collisions, too, as if these were ticks.
   Disks touch each other or a wall at such a moment, so they are seen at
   the walls too often.

   And the clock went on from the collision instead of from the tick: the
   samples were not equally far apart.

   All three go away when the clock leads. `now` is always the time of the
   disks, and nothing else. Up to the next tick all collisions take place,
   one by one, each followed by a new question what comes next; then the
   rest of the way to the tick is flown. A while lets any number of
   collisions go by, and with <= one that falls on the tick as well. The
   time of a tick is a product, rounded once, see exercise 02b.

   Another way: keep no times at all, only how much of the tick is left and
   how long it is to the next collision, and do what is shorter. */

#include "exercise.h"
#include <stddef.h>

struct box;
double box_next(struct box *box);
void box_fly(struct box *box, double time);
void box_collide(struct box *box);
void box_record(struct box *box, double t);

void box_run(struct box *box, double tick, size_t samples)
{
    double now = 0.0, event = box_next(box);
    for (size_t k = 0; k < samples;) {
        const double sample = (double)++k * tick;
        while (event <= sample) {
            box_fly(box, event - now);
            box_collide(box);
            now = event;
            event += box_next(box);
        }
        box_fly(box, sample - now);
        now = sample;
        box_record(box, now);
    }
}
