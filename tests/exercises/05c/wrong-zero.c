/* mistake: starts-at-zero */

#include "exercise.h"
#include <stddef.h>

struct box;
double box_next(struct box *box);
void box_fly(struct box *box, double time);
void box_collide(struct box *box);
void box_record(struct box *box, double t);

void box_run(struct box *box, double tick, size_t samples)
{
    double left = tick, wait = box_next(box);
    size_t done = 0;
    box_record(box, 0.0);
    samples--;
    while (done < samples) {
        if (wait <= left) {
            box_fly(box, wait);
            box_collide(box);
            left -= wait;
            wait = box_next(box);
        } else {
            box_fly(box, left);
            wait -= left;
            left = tick;
            done++;
            box_record(box, done * tick);
        }
    }
}
