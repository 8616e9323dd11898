/* mistake: none */
/* unnamed: asked-before-the-collision */
/* What comes next is asked before the collision has changed the velocities.
 */

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
            now = event;
            event += box_next(box);
            box_collide(box);
        }
        box_fly(box, sample - now);
        now = sample;
        box_record(box, now);
    }
}
