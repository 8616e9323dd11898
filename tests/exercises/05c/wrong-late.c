/* mistake: collides-at-the-tick */

#include "exercise.h"
#include <stddef.h>

struct box;
double box_next(struct box *box);
void box_fly(struct box *box, double time);
void box_collide(struct box *box);
void box_record(struct box *box, double t);

void box_run(struct box *box, double tick, size_t samples)
{
    double t = 0.0, event = box_next(box);
    for (size_t k = 0; k < samples; ++k) {
        box_fly(box, tick);
        t += tick;
        if (event <= t) {
            box_collide(box);
            event = t + box_next(box);
        }
        box_record(box, t);
    }
}
