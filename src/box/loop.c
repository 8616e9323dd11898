/* Moves disks from tick to tick, and measures how deeply they overlap. */
#include "box/loop.h"

#include <math.h>

void loop_event(struct loop *l)
{
    disks_collide(&l->d, l->next);
    l->next = disks_next(&l->d);
}

/* Advances all disks by `step` seconds, which may be negative. Then sets
   their `since` to l->t, whether or not that is the right time. */
static void shift(struct loop *l, double step)
{
    for (size_t i = 0; i < l->d.count; ++i) {
        struct disk *a = &l->d.disk[i];
        for (size_t k = 0; k < DISKS_AXES; ++k)
            a->position[k] += a->velocity[k] * step;
        a->since = l->t;
    }
    l->d.now = l->t;
}

void loop_turn(struct loop *l, double every)
{
    l->t += every;
    if (l->t < l->next.time) {
        shift(l, every);
        return;
    }
    const double step = l->next.time - l->t + l->offset * every;
    l->t = l->next.time;
    shift(l, step);
    loop_event(l);
}

void loop_go_to(struct loop *l, double tick)
{
    while (l->next.time <= tick)
        loop_event(l);
    l->t = l->d.now = tick;
}

double loop_overlap(const struct loop *l)
{
    double deepest = 0;
    for (size_t i = 0; i < l->d.count; ++i) {
        double a[DISKS_AXES], b[DISKS_AXES], x[DISKS_AXES];
        const double radius = l->d.disk[i].radius;
        disks_position(&l->d, i, a);
        for (size_t k = 0; k < l->d.dimensions; ++k) {
            const double nearest = fmin(a[k], l->d.box[k] - a[k]);
            deepest = fmax(deepest, radius - nearest);
        }
        for (size_t j = 0; j < i; ++j) {
            disks_position(&l->d, j, b);
            disks_separation(&l->d, a, b, x);
            const double s = hypot(x[0], x[1]);
            deepest = fmax(deepest, radius + l->d.disk[j].radius - s);
        }
    }
    return deepest;
}
