/* From chapters/05-disks.nw: edit there, then run make tangle. */
/* checksum 329716501 of the lines below */
/* Runs disks from event to event, over all pairs or by a plan per disk. */
#include "box/disks.h"

#include "box/falling.h"
#include "box/image.h"
#include "box/meetings.h"
#include "box/plan.h"
#include "line/collide.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static uint32_t low(struct disks_event e)
{
    return e.disk < e.partner ? e.disk : e.partner;
}

static uint32_t high(struct disks_event e)
{
    return e.disk < e.partner ? e.partner : e.disk;
}

bool disks_before(struct disks_event a, struct disks_event b)
{
    if (a.time != b.time)
        return a.time < b.time;
    if (low(a) != low(b))
        return low(a) < low(b);
    return high(a) < high(b);
}

static struct disks_event event_of(size_t i, size_t j, double time)
{
    return (struct disks_event){time, (uint32_t)i, (uint32_t)j};
}

/* Returns the first event of disk i that involves no other disk: a meeting
   with a wall, or the need for a new plan after a long flight. */
static struct disks_event alone(const struct disks *d, size_t i,
                                double replan)
{
    const double *v = d->disk[i].velocity;
    size_t axis;
    double vv = 0;
    const double time = disks_wall(d, i, &axis);
    const struct disks_event wall = event_of(i, d->count + axis, time);
    if (replan == INFINITY)
        return wall;
    for (size_t k = 0; k < d->dimensions; ++k)
        vv += wraps(d, k) ? v[k] * v[k] : 0;
    const struct disks_event look =
        event_of(i, i, d->now + replan / sqrt(vv));
    return look.time < time ? look : wall;
}

struct disks_event disks_next(const struct disks *d)
{
    const double replan = disks_replan_distance(d);
    struct disks_event first = alone(d, 0, replan);
    for (size_t i = 0; i < d->count; ++i) {
        const struct disks_event own = alone(d, i, replan);
        if (disks_before(own, first))
            first = own;
        for (size_t j = i + 1; j < d->count; ++j) {
            const struct disks_event pair =
                event_of(i, j, disks_meeting(d, i, j, d->now));
            if (disks_before(pair, first))
                first = pair;
        }
    }
    return first;
}

static void move_to(const struct disks *d, struct disk *a, double time)
{
    for (size_t k = 0; k < DISKS_AXES; ++k)
        a->position[k] += a->velocity[k] * (time - a->since);
    if (d->gravity > 0)
        falling_move(d, time - a->since, a->position, a->velocity);
    a->since = time;
}

static void meet_wall(struct disks *d, size_t i, size_t k)
{
    struct disk *a = &d->disk[i];
    if (d->gravity > 0 && k == 1)
        falling_land(d, a);
    else
        move_to(d, a, d->now);
    const double v = a->velocity[k];
    ++d->hits[i];
    a->velocity[k] = -d->restitution * v;
    d->impulse[k] += d->mass[i] * fabs(v - a->velocity[k]);
    ++d->wall_collisions;
}

static void meet_disk(struct disks *d, size_t i, size_t j)
{
    struct disk *a = &d->disk[i], *b = &d->disk[j];
    double normal[DISKS_AXES], before[DISKS_AXES], moved = 0;
    move_to(d, a, d->now);
    move_to(d, b, d->now);
    ++d->hits[i];
    ++d->hits[j];
    disks_separation(d, a->position, b->position, normal);
    memcpy(before, a->velocity, sizeof before);
    collide_along(DISKS_AXES, normal, a->velocity, b->velocity,
                  1 / d->mass[i], 1 / d->mass[j], d->restitution);
    for (size_t k = 0; k < DISKS_AXES; ++k)
        moved += (before[k] - a->velocity[k]) * normal[k];
    d->virial += d->mass[i] * moved;
    ++d->collisions;
}

void disks_collide(struct disks *d, struct disks_event e)
{
    const double now = e.time > d->now ? e.time : d->now;
    d->standing = now > d->now ? 0 : d->standing + 1;
    d->now = now;
    if (e.partner >= d->count)
        meet_wall(d, e.disk, e.partner - d->count);
    else if (e.partner != e.disk)
        meet_disk(d, low(e), high(e));
}

/* Returns the smallest of n times and sets *first to its index, or to n if
   all times are INFINITY. */
static double soonest(const double time[], size_t n, size_t *first)
{
    double least = INFINITY;
    *first = n;
    for (size_t j = 0; j < n; ++j) {
        *first = time[j] < least ? j : *first;
        least = time[j] < least ? time[j] : least;
    }
    return least;
}

/* Plans the next event of disk i, as seen at the time d->now. */
static void plan_disk(struct disks *d, size_t i)
{
    struct disks_plan *p = d->plan;
    struct disks_event first = alone(d, i, p->replan);
    meetings_of(d, i, p->time);
    p->time[i] = INFINITY;
    size_t j;
    const double time = soonest(p->time, d->count, &j);
    const struct disks_event pair = event_of(i, j, time);
    if (disks_before(pair, first))
        first = pair;
    p->event[i] = first;
    p->hits[i] = first.partner < d->count ? d->hits[first.partner] : 0;
}

static struct disks_event earliest(const struct disks *d)
{
    const struct disks_event *event = d->plan->event;
    double time = event[0].time;
    size_t first = 0, ties = 0;
    for (size_t i = 1; i < d->count; ++i) {
        const double t = event[i].time;
        ties += t == time;
        first = t < time ? i : first;
        time = t < time ? t : time;
    }
    for (size_t i = first + 1; ties > 0 && i < d->count; ++i)
        if (event[i].time == time && disks_before(event[i], event[first]))
            first = i;
    return event[first];
}

static bool still_true(const struct disks *d, struct disks_event e)
{
    return e.partner >= d->count ||
           (e.partner != e.disk &&
            d->plan->hits[e.disk] == d->hits[e.partner]);
}

enum disks_stop disks_run(struct disks *d, double until,
                          uint64_t collisions)
{
    while (d->collisions < collisions) {
        const struct disks_event e = earliest(d);
        if (e.time > until || e.time == INFINITY) {
            if (until < INFINITY)
                d->now = fmax(d->now, until);
            return DISKS_TIME;
        }
        if (still_true(d, e)) {
            disks_collide(d, e);
            if (disks_over(d, e.disk))
                return DISKS_COLLAPSE;
            if (e.partner < d->count)
                plan_disk(d, e.partner);
        } else
            d->now = fmax(d->now, e.time);
        plan_disk(d, e.disk);
    }
    return DISKS_COLLISIONS;
}

void disks_position(const struct disks *d, size_t i, double place[])
{
    const struct disk *a = &d->disk[i];
    for (size_t k = 0; k < DISKS_AXES; ++k)
        place[k] = a->position[k] + a->velocity[k] * (d->now - a->since);
    if (d->gravity > 0)
        falling_move(d, d->now - a->since, place, NULL);
}

void disks_velocity(const struct disks *d, size_t i, double velocity[])
{
    const struct disk *a = &d->disk[i];
    for (size_t k = 0; k < DISKS_AXES; ++k)
        velocity[k] = a->velocity[k];
    if (d->gravity > 0)
        velocity[1] -= d->gravity * (d->now - a->since);
}

bool disks_plan(struct disks *d)
{
    if (!d->plan && !(d->plan = calloc(1, sizeof *d->plan)))
        return false;
    struct disks_plan *p = d->plan;
    if (!p->event)
        p->event = malloc(d->count * sizeof *p->event);
    if (!p->hits)
        p->hits = malloc(d->count * sizeof *p->hits);
    if (!p->time)
        p->time = malloc(d->count * sizeof *p->time);
    if (!p->event || !p->hits || !p->time)
        return false;
    p->replan = disks_replan_distance(d);
    assert(p->replan > 0);
    for (size_t i = 0; i < d->count; ++i)
        plan_disk(d, i);
    return true;
}
