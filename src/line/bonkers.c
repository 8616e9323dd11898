/* From chapters/02-bonkers.nw: edit there, then run make tangle. */
/* checksum 3158526686 of the lines below */
/* Finds the next collision on a line, by one of four engines. */
#include "line/bonkers.h"

#include "line/collide.h"
#include "line/engine.h"
#include "line/gap.h"
#include "line/slab.h"

#include <float.h>
#include <math.h>

static void move_all(struct bonkers *b, double wait)
{
    for (size_t i = 0; i <= b->gaps; ++i)
        b->body[i].x += b->body[i].v * wait;
}

/* Ends a run in which nothing happens before `until`: moves all bodies to
   that time, unless it is infinite. */
static enum bonkers_stop idle_all(struct bonkers *b, double until)
{
    if (until == INFINITY)
        return BONKERS_STILL;
    move_all(b, until - b->now);
    b->now = until;
    return BONKERS_TIME;
}

/* Moves all bodies for `wait` seconds, until gap i closes, and collides the
   two bodies of this gap. Returns whether the run ends as
   BONKERS_COLLAPSE. */
static bool move_and_collide(struct bonkers *b, size_t i, double wait)
{
    struct bonkers_body *left = &b->body[i], *right = left + 1;
    const bool stands = same_time(b->now, b->now + wait);
    const double approach = left->v - right->v;
    move_all(b, wait);
    b->now += wait;
    collide(&left->v, &right->v, left->im, right->im, b->restitution);
    ++b->collisions;
    return count_repeat(b, i, stands, approach);
}

/* For every collision, computes all times anew and moves all bodies. */
static enum bonkers_stop run_naive(struct bonkers *b, double until,
                                   uint64_t limit)
{
    for (;;) {
        size_t first = 0;
        double wait = INFINITY;
        for (size_t i = 0; i < b->gaps; ++i) {
            const double gap = b->body[i + 1].x - b->body[i].x;
            const double approach = b->body[i].v - b->body[i + 1].v;
            if (approach > 0 && gap < wait * approach) {
                wait = gap > 0 ? gap / approach : 0;
                first = i;
            }
        }
        if (wait == INFINITY || b->now + wait > until)
            return idle_all(b, until);
        if (move_and_collide(b, first, wait))
            return BONKERS_COLLAPSE;
        if (b->collisions == limit)
            return BONKERS_COLLISIONS;
    }
}

enum bonkers_stop engine_idle(struct bonkers *b, double until)
{
    if (until < INFINITY) {
        b->now = until;
        return BONKERS_TIME;
    }
    b->now = b->begun;
    for (size_t i = 0; i <= b->gaps; ++i)
        b->now = fmax(b->now, b->body[i].since);
    return BONKERS_STILL;
}

/* For every collision, compares all stored times and moves two bodies. */
static enum bonkers_stop run_scan(struct bonkers *b, double until,
                                  uint64_t limit)
{
    for (;;) {
        const size_t i = schedule_scan(b->due, b->gaps);
        if (b->due[i] > until || b->due[i] == INFINITY)
            return engine_idle(b, until);
        const bool collapse = collide_gap(b, i);
        renew(b, i);
        ++b->collisions;
        if (collapse)
            return BONKERS_COLLAPSE;
        if (b->collisions == limit)
            return BONKERS_COLLISIONS;
    }
}

void engine_reschedule(struct bonkers *b, size_t i)
{
    if (b->due[i] < INFINITY)
        schedule_put(&b->schedule, i, b->due[i]);
    else
        schedule_drop(&b->schedule, i);
}

/* For every collision, takes the earliest gap from the top of the heap and
   moves only two bodies. */
enum bonkers_stop engine_run_heap(struct bonkers *b, double until,
                                  uint64_t limit)
{
    for (;;) {
        if (b->schedule.count == 0 || b->schedule.heap[0].time > until)
            return engine_idle(b, until);
        const size_t i = b->schedule.heap[0].event;
        size_t low, high;
        const bool collapse = collide_gap(b, i);
        renew(b, i);
        find_changed(b, i, &low, &high);
        for (size_t k = low; k <= high; ++k)
            engine_reschedule(b, k);
        ++b->collisions;
        if (collapse)
            return BONKERS_COLLAPSE;
        if (b->collisions == limit)
            return BONKERS_COLLISIONS;
    }
}

double engine_rounding(const struct bonkers *b, size_t i)
{
    double scale = 0;
    for (size_t k = i > 0 ? i - 1 : 0; k <= i; ++k) {
        const struct bonkers_body a = body_at(b, k, b->now);
        const double x = fabs(a.x);
        scale += x > b->extent && x < INFINITY ? x : b->extent;
        scale += fmax(fabs(b->body[k].v), fabs(a.v)) * b->now;
    }
    return 8 * DBL_EPSILON * scale;
}

void bonkers_state(struct bonkers *b, double x[], double v[])
{
    const double right = b->body[b->gaps].x;
    double last = b->body[0].x;
    for (size_t i = 0; i <= b->gaps; ++i) {
        const struct bonkers_body a = body_at(b, i, b->now);
        if (a.x < last && a.x < last - engine_rounding(b, i))
            ++b->disorder;
        last = a.x < last ? last : a.x > right ? right : a.x;
        x[i] = b->shift ? last + b->shift[i] : last;
        v[i] = a.v;
    }
}

static enum bonkers_stop set_clocks(struct bonkers *b,
                                    enum bonkers_stop stop)
{
    for (size_t i = 0; i <= b->gaps; ++i)
        b->body[i].since = b->now;
    return stop;
}

enum bonkers_stop bonkers_run(struct bonkers *b, double until,
                              uint64_t collisions)
{
    if (b->collisions >= collisions)
        return BONKERS_COLLISIONS;
    b->begun = b->now;
    switch (b->engine) {
    case BONKERS_NAIVE:
        return b->gravity > 0
                   ? weight_run_naive(b, until, collisions)
                   : set_clocks(b, run_naive(b, until, collisions));
    case BONKERS_SCAN: return run_scan(b, until, collisions);
    case BONKERS_HEAP: return engine_run_heap(b, until, collisions);
    default: return slab_run(b, until, collisions);
    }
}
