/* From chapters/02-bonkers.nw: edit there, then run make tangle. */
/* checksum 4076897025 of the lines below */
/* Four engines that find the next collision on a line and carry it out. */
#include "line/bonkers.h"

#include "line/collide.h"
#include "line/fall.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double position(const struct bonkers_body *a, double t)
{
    return a->x + a->v * (t - a->since);
}

/* When the gap to the right of this body closes (2.3, eq:gap-time). */
static double time_of_gap(const struct bonkers_body *left)
{
    const struct bonkers_body *right = left + 1;
    const double approach = left->v - right->v;
    if (!(approach > 0))
        return INFINITY;
    const double t =
        left->since > right->since ? left->since : right->since;
    const double gap = position(right, t) - position(left, t);
    return gap > 0 ? t + gap / approach : t;
}

/* Nothing more happens before `until`: let the clock run on, or stop it
   at the last collision if there is no end. */
static enum bonkers_stop idle(struct bonkers *b, double until)
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

/* As good as the same time: a few last bits of the clock. */
static bool at_once(double before, double t)
{
    return t - before <= 4 * DBL_EPSILON * t;
}

/* How many collisions of a gap at one time are a collapse. */
static uint32_t patience(const struct bonkers *b)
{
    return BONKERS_REPEATS + (b->gaps < 200 ? (uint32_t)b->gaps : 200);
}

/* Counts the collisions of gap i at one reading of the clock, which
   stands or has moved on. Returns true when there are too many, or when
   the two have come together too slowly for numbers. */
static bool count_repeat(struct bonkers *b, size_t i, bool stands,
                         double approach)
{
    if (!b->repeats)
        return false;
    b->repeats[i] = stands ? b->repeats[i] + 1 : 0;
    return b->repeats[i] >= patience(b) ||
           (!stands && approach < BONKERS_SLOWEST);
}

static bool rests(const struct bonkers *b, const struct bonkers_body *a)
{
    return a->im == 0 || (a->v == 0 && a->x <= b->body[0].x);
}

/* A body as it is at a time, if it meets nobody until then (5.12,
   eq:fall). */
static struct bonkers_body body_at(const struct bonkers *b, size_t i,
                                   double t)
{
    struct bonkers_body a = b->body[i];
    const double wait = t - a.since, g = b->gravity;
    if (!(g > 0)) {
        a.x = position(&a, t);
    } else if (!rests(b, &a)) {
        a.x += (a.v - g * wait / 2) * wait;
        a.v -= g * wait;
    }
    a.since = t;
    return a;
}

/* When gap i closes under gravity. A pair that falls: exercise 05b. */
static double time_of_fall(const struct bonkers *b, size_t i)
{
    const double t = fmax(b->body[i].since, b->body[i + 1].since);
    const struct bonkers_body left = body_at(b, i, t);
    const struct bonkers_body right = body_at(b, i + 1, t);
    const bool held = rests(b, &b->body[i]);
    const double gap = right.x - left.x, approach = left.v - right.v;
    if (held != rests(b, &b->body[i + 1]))
        return t + (held ? fall_to_floor(gap, right.v, b->gravity)
                         : fall_to_roof(gap, left.v, b->gravity));
    if (!(approach > 0))
        return INFINITY;
    return gap > 0 ? t + gap / approach : t;
}

/* time_of_gap with both of its answers computed: the same bits. */
static double time_of_either(const struct bonkers_body *left)
{
    const struct bonkers_body *right = left + 1;
    const double approach = left->v - right->v;
    const double t =
        left->since > right->since ? left->since : right->since;
    const double gap = position(right, t) - position(left, t);
    const double due[] = {INFINITY, t + (gap > 0 ? gap : 0) / approach};
    return due[approach > 0];
}

static double time_due(const struct bonkers *b, size_t i)
{
    return b->gravity > 0 ? time_of_fall(b, i)
                          : time_of_either(&b->body[i]);
}

/* Brings the bodies of gap i together at t, one of which rests. */
static void land(struct bonkers *b, size_t i, double t)
{
    struct bonkers_body *left = &b->body[i], *right = left + 1;
    const double gap = right->x - left->x;
    if (rests(b, left)) {
        right->v = -fall_speed(gap, right->v, b->gravity);
        right->x = left->x;
    } else {
        left->v = fall_speed(-gap, left->v, b->gravity);
        left->x = right->x;
    }
    left->since = right->since = t;
}

enum { PILE = 1000 }; /* times more patient with a pile */

/* Whether a body is at the floor, but for rounding. */
static bool is_low(const struct bonkers *b, const struct bonkers_body *a)
{
    return fabs(a->x - b->body[0].x) <= 4 * DBL_EPSILON * b->extent;
}

/* Lets a body rest on the floor after a bounce too low for the clock. */
static void calm(const struct bonkers *b, struct bonkers_body *a)
{
    const double flight = 2 * fabs(a->v) / b->gravity;
    if (b->restitution < 1 && is_low(b, a) &&
        at_once(a->since, a->since + flight)) {
        a->x = b->body[0].x;
        a->v = 0;
    }
}

/* Collides the bodies of gap i, as collide_gap does, under gravity. */
static bool meet_falling(struct bonkers *b, size_t i)
{
    struct bonkers_body *left = &b->body[i], *right = left + 1;
    const double t = b->due[i];
    const bool stands = at_once(left->since, t) && at_once(right->since, t);
    if (rests(b, left) != rests(b, right)) {
        land(b, i, t);
    } else {
        *left = body_at(b, i, t);
        *right = body_at(b, i + 1, t);
    }
    const double v = left->v, w = right->v;
    const double late = v > w ? (left->x - right->x) / (v - w) : 0;
    collide(&left->v, &right->v, left->im, right->im, b->restitution);
    left->x += (left->v - v) * late;
    right->x += (right->v - w) * late;
    calm(b, left);
    calm(b, right);
    b->now = t;
    const bool pile = is_low(b, right); /* and so is what is below it */
    return count_repeat(b, i, stands, INFINITY) &&
           (!pile || b->repeats[i] >= PILE * patience(b));
}

static void move_all(struct bonkers *b, double wait)
{
    for (size_t i = 0; i <= b->gaps; ++i)
        b->body[i].x += b->body[i].v * wait;
}

/* Nothing happens before `until`: goes there, if it is a time. */
static enum bonkers_stop idle_all(struct bonkers *b, double until)
{
    if (until == INFINITY)
        return BONKERS_STILL;
    move_all(b, until - b->now);
    b->now = until;
    return BONKERS_TIME;
}

/* Moves everybody to the next collision, which is in gap i. Returns true
   when the clock has stood still for too long. */
static bool move_and_collide(struct bonkers *b, size_t i, double wait)
{
    struct bonkers_body *left = &b->body[i], *right = left + 1;
    const bool stands = at_once(b->now, b->now + wait);
    const double approach = left->v - right->v;
    move_all(b, wait);
    b->now += wait;
    collide(&left->v, &right->v, left->im, right->im, b->restitution);
    ++b->collisions;
    return count_repeat(b, i, stands, approach);
}

static enum bonkers_stop set_clocks(struct bonkers *b,
                                    enum bonkers_stop stop)
{
    for (size_t i = 0; i <= b->gaps; ++i)
        b->body[i].since = b->now;
    return stop;
}

/* At every event look at every gap and move everybody. */
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

static enum bonkers_stop run_naive_falling(struct bonkers *b, double until,
                                           uint64_t limit)
{
    for (;;) {
        for (size_t i = 0; i < b->gaps; ++i)
            b->due[i] = time_of_fall(b, i);
        const size_t i = schedule_scan(b->due, b->gaps);
        const double t = fmin(b->due[i], until);
        for (size_t k = 0; k <= b->gaps && t < INFINITY; ++k)
            b->body[k] = body_at(b, k, t);
        if (b->due[i] > until || b->due[i] == INFINITY)
            return idle(b, until);
        const bool collapse = meet_falling(b, i);
        ++b->collisions;
        if (collapse)
            return BONKERS_COLLAPSE;
        if (b->collisions == limit)
            return BONKERS_COLLISIONS;
    }
}

/* The fraction f of (1.12, eq:smaller); no number where none can move. */
static double fraction(const struct bonkers *b, size_t i)
{
    const double left = b->body[i].im, right = b->body[i + 1].im;
    const double sum = left + right;
    return sum <= DBL_MAX ? (left < right ? left : right) / sum : NAN;
}

/* Does to the velocities what collide does. */
static void exchange(struct bonkers *b, size_t i)
{
    struct bonkers_body *left = &b->body[i], *right = left + 1;
    const double f = b->fraction ? b->fraction[i] : fraction(b, i);
    const double change = (1 + b->restitution) * (left->v - right->v);
    const bool heavier = left->im >= right->im;
    double part[2];
    if (!(f >= 0))
        return;
    part[heavier] = change * f;
    part[!heavier] = change - part[heavier];
    left->v -= part[0];
    right->v += part[1];
}

/* Collides the bodies of gap i at the time it is due. Returns true when the
   clock has stood still for too long. */
static bool collide_gap(struct bonkers *b, size_t i)
{
    if (b->gravity > 0)
        return meet_falling(b, i);
    struct bonkers_body *left = &b->body[i], *right = left + 1;
    const double t = b->due[i];
    const double l = position(left, t), r = position(right, t);
    const bool stands = at_once(left->since, t) && at_once(right->since, t);
    const double place[] = {r, l}, approach = left->v - right->v;
    left->x = right->x = place[fabs(left->v) < fabs(right->v)];
    left->since = right->since = b->now = t;
    exchange(b, i);
    return count_repeat(b, i, stands, approach);
}

/* The gaps that a collision in gap i has touched: from *low to *high. */
static void touched(const struct bonkers *b, size_t i, size_t *low,
                    size_t *high)
{
    *low = i > 0 ? i - 1 : 0;
    *high = i + 1 < b->gaps ? i + 1 : i;
}

static void renew(struct bonkers *b, size_t i)
{
    size_t low, high;
    touched(b, i, &low, &high);
    for (size_t k = low; k <= high; ++k)
        b->due[k] = time_due(b, k);
}

/* Look at every remembered time; move two bodies. */
static enum bonkers_stop run_scan(struct bonkers *b, double until,
                                  uint64_t limit)
{
    for (;;) {
        const size_t i = schedule_scan(b->due, b->gaps);
        if (b->due[i] > until || b->due[i] == INFINITY)
            return idle(b, until);
        const bool collapse = collide_gap(b, i);
        renew(b, i);
        ++b->collisions;
        if (collapse)
            return BONKERS_COLLAPSE;
        if (b->collisions == limit)
            return BONKERS_COLLISIONS;
    }
}

/* Only gaps that will close are in the schedule. */
static void reschedule(struct bonkers *b, size_t i)
{
    if (b->due[i] < INFINITY)
        schedule_put(&b->schedule, i, b->due[i]);
    else
        schedule_drop(&b->schedule, i);
}

/* The earliest gap is on top; move two bodies. */
static enum bonkers_stop run_heap(struct bonkers *b, double until,
                                  uint64_t limit)
{
    for (;;) {
        size_t low, high;
        if (b->schedule.count == 0 || b->schedule.heap[0].time > until)
            return idle(b, until);
        const struct schedule_entry next = b->schedule.heap[0];
        const bool collapse = collide_gap(b, next.event);
        renew(b, next.event);
        touched(b, next.event, &low, &high);
        for (size_t k = low; k <= high; ++k)
            reschedule(b, k);
        ++b->collisions;
        if (collapse)
            return BONKERS_COLLAPSE;
        if (b->collisions == limit)
            return BONKERS_COLLISIONS;
    }
}

/* What a collision overwrites. */
struct record {
    double x[2], v[2], since[2];
    uint32_t gap, repeats;
};

/* Gaps first to last, and where their records begin in the log. */
struct island {
    uint32_t first, last;
    size_t start;
};

/* A slab on its way from left to right. */
struct slab {
    double end;  /* s */
    size_t next; /* the gaps before it are done with */
    struct record *log;
    size_t logged, log_size;
    struct island *island;
    size_t islands, island_size;
    uint64_t collisions; /* whose records have been dropped */
};

enum {
    SLABS = 16,  /* under way at once, at most */
    WARY = 63,   /* slabs alone after failures, at most */
    CROWD = 4096 /* gaps of an island that wait, at most */
};

/* What collisions change in a body. */
struct flight {
    double x, v, since;
};

struct bonkers_slab {
    double width;        /* of the next slabs, s; 0: not known */
    size_t slabs, count; /* to be under way, and now */
    size_t alone, wary;  /* to go alone: still, and after a failure */
    struct slab slab[SLABS + 2];
    struct flight *saved;
    uint32_t *repeats; /* saved, too */
    uint64_t redone;   /* in these slabs */
    bool collapse, failed, crowded;
};

/* Goes without slabs, too. */
static void free_slabs(struct bonkers_slab *s)
{
    for (size_t k = 0; s && k < SLABS + 2; ++k) {
        free(s->slab[k].log);
        free(s->slab[k].island);
    }
    if (s) {
        free(s->saved);
        free(s->repeats);
    }
    free(s);
}

/* Returns NULL when there is no memory. */
static struct bonkers_slab *create_slabs(const struct bonkers *b)
{
    struct bonkers_slab *s = calloc(1, sizeof *s);
    if (!s)
        return NULL;
    s->slabs = 1;
    s->saved = malloc((b->gaps + 1) * sizeof *s->saved);
    if (b->repeats)
        s->repeats = malloc(b->gaps * sizeof *s->repeats);
    if (s->saved && (s->repeats || !b->repeats))
        return s;
    free_slabs(s);
    return NULL;
}

static struct record record_of(const struct bonkers *b, size_t i)
{
    const struct bonkers_body *l = &b->body[i], *r = l + 1;
    return (struct record){{l->x, r->x},
                           {l->v, r->v},
                           {l->since, r->since},
                           (uint32_t)i,
                           b->repeats ? b->repeats[i] : 0};
}

static void undo(struct bonkers *b, const struct record *r)
{
    struct bonkers_body *pair = &b->body[r->gap];
    for (int k = 0; k < 2; ++k) {
        pair[k].x = r->x[k];
        pair[k].v = r->v[k];
        pair[k].since = r->since[k];
    }
    if (b->repeats)
        b->repeats[r->gap] = r->repeats;
    renew(b, r->gap);
}

/* Undoes all but the first `start` records. */
static void undo_to(struct bonkers *b, struct slab *s, size_t start)
{
    b->slab->redone += s->logged - start;
    while (s->logged > start)
        undo(b, &s->log[--s->logged]);
}

/* Makes room for one more of `size` bytes. */
static bool make_room(void **array, size_t count, size_t *room, size_t size)
{
    if (count < *room)
        return true;
    const size_t more = *room * 3 / 2 + 256;
    void *larger = realloc(*array, more * size);
    if (!larger)
        return false;
    *array = larger;
    *room = more;
    return true;
}

/* The last gap of the chain of gaps due before `end` that begins at last,
   with never more than one that is not due in between. */
static size_t chain(const struct bonkers *b, size_t last, double end)
{
    for (;;)
        if (last + 2 < b->gaps && b->due[last + 2] <= end)
            last += 2;
        else if (last + 1 < b->gaps && b->due[last + 1] <= end)
            last += 1;
        else
            return last;
}

/* Schedules the gaps first to last that are due; takes the earliest. */
static size_t gather(struct bonkers *b, size_t first, size_t last,
                     double end)
{
    for (size_t k = first; k <= last && b->schedule.count < CROWD; ++k)
        if (b->due[k] <= end)
            schedule_put(&b->schedule, k, b->due[k]);
    return schedule_take(&b->schedule);
}

/* Renews the times around gap i, and schedules what has become due. */
static void post(struct bonkers *b, size_t i, double end)
{
    size_t low, high;
    touched(b, i, &low, &high);
    for (size_t k = low; k <= high; ++k) {
        const double t = b->due[k] = time_due(b, k);
        if (t <= end)
            schedule_put(&b->schedule, k, t);
        else if (b->schedule.count > 0)
            schedule_drop(&b->schedule, k);
    }
}

/* Whether gaps first to last are more than slab s has to itself. */
static bool too_near(const struct slab *s, size_t first, size_t last)
{
    const struct slab *before = s - 1, *behind = s + 1;
    return last + 3 > before->next ||
           (behind->next > 0 && first <= behind->next);
}

static bool too_long(const struct bonkers *b, const struct slab *s)
{
    const size_t most = 8 * b->gaps + 65536;
    return s->logged > most || b->slab->redone > most;
}

/* Runs the gaps *first to *last, and those they set going, up to the time
   `end`. Returns false with a larger *first to *last when the island has
   to be begun again: it has met another. */
static bool run_island(struct bonkers *b, struct slab *s, size_t *first,
                       size_t *last)
{
    const double end = s->end;
    size_t i = *first;
    if (*first < *last)
        i = gather(b, *first, *last, end);
    for (;;) {
        if (i < *first) {
            *first = i;
            if (s->islands > 0 &&
                i <= s->island[s->islands - 1].last + (size_t)2)
                return false;
        } else if (i > *last) {
            *last = i;
            if (i + 2 < b->gaps && b->due[i + 2] <= end) {
                *last = i + 2;
                return false;
            }
        }
        b->slab->crowded |= b->schedule.count + 3 > CROWD;
        if (b->slab->crowded || too_long(b, s) ||
            too_near(s, *first, *last) ||
            !make_room((void **)&s->log, s->logged, &s->log_size,
                       sizeof *s->log)) {
            b->slab->failed = true;
            return false;
        }
        s->log[s->logged++] = record_of(b, i);
        if (collide_gap(b, i)) {
            b->slab->collapse = true;
            schedule_clear(&b->schedule);
            renew(b, i);
            return true;
        }
        post(b, i, end);
        if (b->schedule.count == 0)
            return true;
        i = schedule_take(&b->schedule);
    }
}

/* Runs the island that begins at gap first. Returns the first gap after
   it that may begin another, or 0 if the slab is too long. */
static size_t add_island(struct bonkers *b, struct slab *s, size_t first)
{
    size_t start = s->logged, last = chain(b, first, s->end);
    while (!run_island(b, s, &first, &last)) {
        schedule_clear(&b->schedule);
        undo_to(b, s, start);
        if (b->slab->failed)
            return 0;
        while (s->islands > 0 &&
               first <= s->island[s->islands - 1].last + (size_t)2) {
            const struct island *left = &s->island[--s->islands];
            start = left->start;
            first = left->first;
            undo_to(b, s, start);
        }
        last = chain(b, last, s->end);
    }
    if (!make_room((void **)&s->island, s->islands, &s->island_size,
                   sizeof *s->island)) {
        b->slab->failed = true;
        return 0;
    }
    s->island[s->islands++] =
        (struct island){(uint32_t)first, (uint32_t)last, start};
    return last + 3;
}

enum { BLOCK = 256 };

/* Remembers gaps from to to-1 and the bodies to their left. */
static void save(struct bonkers *b, size_t from, size_t to)
{
    const size_t count = to - from + (to == b->gaps);
    struct bonkers_slab *s = b->slab;
    for (size_t i = from; i < from + count; ++i) {
        const struct bonkers_body *a = &b->body[i];
        s->saved[i] = (struct flight){a->x, a->v, a->since};
    }
    if (b->repeats)
        memcpy(&s->repeats[from], &b->repeats[from],
               (to - from) * sizeof *b->repeats);
    s->slab[0].next = to == b->gaps ? SIZE_MAX : to;
#ifdef __GNUC__
    for (size_t i = to; i < to + BLOCK && i <= b->gaps; i += 2)
        __builtin_prefetch(&b->body[i], 1);
#endif
}

/* Takes all bodies back to where they have been saved. */
static void undo_all(struct bonkers *b)
{
    const struct bonkers_slab *s = b->slab;
    const size_t next = s->slab[0].next;
    const size_t gaps = next < b->gaps ? next : b->gaps;
    for (size_t i = 0; i < gaps + (next > gaps); ++i) {
        const struct flight *a = &s->saved[i];
        b->body[i] =
            (struct bonkers_body){a->x, a->v, a->since, b->body[i].im};
    }
    if (b->repeats)
        memcpy(b->repeats, s->repeats, gaps * sizeof *b->repeats);
    for (size_t i = 0; i < gaps; ++i)
        b->due[i] = time_due(b, i);
}

static void forget(struct slab *s)
{
    enum { MANY = 256 };
    const size_t seen = s[1].next;
    size_t kept = 0;
    if (s->logged < MANY)
        return;
    while (kept < s->islands && s->island[kept].last + (size_t)2 <= seen)
        ++kept;
    if (kept == 0)
        return;
    const size_t start =
        kept < s->islands ? s->island[kept].start : s->logged;
    memmove(s->log, s->log + start, (s->logged - start) * sizeof *s->log);
    memmove(s->island, s->island + kept,
            (s->islands - kept) * sizeof *s->island);
    s->logged -= start;
    s->islands -= kept;
    s->collisions += start;
    for (size_t k = 0; k < s->islands; ++k)
        s->island[k].start -= start;
}

/* Runs the islands of slab s that begin in gaps from to to-1. Returns false
   when that is more than a slab can do; then all must be undone. */
static bool walk(struct bonkers *b, struct slab *s, size_t from, size_t to)
{
    const double end = s->end;
    size_t next = s->next;
    uint32_t due[BLOCK];
    size_t count = 0;
    for (size_t i = next > from ? next : from; i < to; ++i) {
        due[count] = (uint32_t)i;
        count += b->due[i] <= end;
    }
    forget(s);
    for (size_t k = 0; k < count; ++k)
        if (due[k] >= next && !(next = add_island(b, s, due[k])))
            return false;
    s->next = to == b->gaps ? SIZE_MAX : next > to ? next : to;
    return true;
}

/* Takes one slab through a block; the first saves it, and the one behind
   the last only shows how far that is done. */
static bool step(struct bonkers *b, size_t slab, size_t block)
{
    struct slab *s = &b->slab->slab[slab];
    const size_t from = block * BLOCK;
    const size_t to = from + BLOCK < b->gaps ? from + BLOCK : b->gaps;
    if (from >= b->gaps)
        return true;
    if (slab > 0 && slab <= b->slab->count)
        return walk(b, s, from, to);
    if (slab == 0 && b->slab->count > 1)
        save(b, from, to);
    else if (b->slab->count > 1)
        s->next = to;
    return true;
}

/* Runs every island of all slabs. Returns false when they have failed. */
static bool run_islands(struct bonkers *b)
{
    const size_t blocks = (b->gaps + BLOCK - 1) / BLOCK;
    const size_t slabs = b->slab->count;
    if (slabs == 1)
        save(b, 0, b->gaps);
    for (size_t block = 0; block < blocks + slabs; ++block)
        for (size_t k = 0; k <= slabs + 1 && k <= block; ++k)
            if (!step(b, k, block - k))
                return false;
    return true;
}

/* Collisions that a slab should have. */
static double plenty(const struct bonkers *b)
{
    return 0.15 * (double)b->gaps + 1;
}

/* Chooses the width of the next slabs from the last, of this width, which
   had so many collisions; 0 after some in which nothing happened. */
static void adapt(struct bonkers *b, double width, uint64_t collisions)
{
    struct bonkers_slab *s = b->slab;
    const double fill = (double)collisions / (double)s->count / plenty(b);
    s->width = collisions == 0 ? 0
               : fill < 0.5    ? 2 * width
               : fill > 2      ? 0.5 * width
                               : width / fill;
    if (s->count == SLABS)
        s->wary /= 2;
    s->slabs = fill < 0.5 || fill > 2 || s->alone > 0 ? 1
               : s->slabs < SLABS                     ? 2 * s->slabs
                                                      : SLABS;
    s->alone -= s->alone > 0;
}

/* The width where nothing is known: reach twice as far as the next
   collision. INFINITY if there is none. */
static double first_width(const struct bonkers *b)
{
    const double wait = b->due[schedule_scan(b->due, b->gaps)] - b->now;
    return wait == INFINITY ? wait
                            : fmin(fmax(2 * wait, 1e-12 * b->now), DBL_MAX);
}

/* Runs slabs of this width from now on, but not beyond `until`; undoes them
   and returns false when they fail. */
static bool try_slabs(struct bonkers *b, double begin, double width,
                      double until)
{
    struct bonkers_slab *all = b->slab;
    for (size_t k = 0; k < SLABS + 2; ++k) {
        struct slab *s = &all->slab[k];
        s->end = fmin(fmin(begin + (double)k * width, DBL_MAX), until);
        s->next = s->logged = s->islands = 0;
        s->collisions = 0;
    }
    all->redone = 0;
    all->collapse = all->failed = all->crowded = false;
    const bool done = run_islands(b);
    if (!done)
        undo_all(b);
    b->redone += all->redone;
    return done;
}

static uint64_t collisions_of(const struct bonkers *b)
{
    uint64_t sum = 0;
    for (size_t k = 1; k <= b->slab->count; ++k)
        sum += b->slab->slab[k].collisions + b->slab->slab[k].logged;
    return sum;
}

static bool holds_the_end(const struct bonkers *b, uint64_t collisions,
                          uint64_t limit)
{
    return b->slab->collapse || collisions >= limit - b->collisions;
}

static enum bonkers_stop run_slab_by_heap(struct bonkers *b, double end,
                                          uint64_t limit)
{
    const struct schedule islands = b->schedule;
    b->schedule.heap = (void *)b->slab->saved;
    for (size_t i = 0; i < b->gaps; ++i)
        reschedule(b, i);
    const enum bonkers_stop stop = run_heap(b, end, limit);
    schedule_clear(&b->schedule);
    b->schedule = islands;
    b->slab->width = 0; /* begin afresh */
    return stop;
}

static size_t how_many(const struct bonkers *b, double width, double until,
                       uint64_t limit)
{
    const double time = (until - b->now) / width;
    const double collisions =
        (double)(limit - b->collisions) / (2 * plenty(b));
    const double most =
        fmin(fmin(ceil(time), collisions), (double)b->slab->slabs);
    return b->slab->width > 0 && most > 1 ? (size_t)most : 1;
}

/* Runs until the time `until`. */
static enum bonkers_stop run_slabs(struct bonkers *b, double until,
                                   uint64_t limit)
{
    struct bonkers_slab *s = b->slab;
    enum bonkers_stop stop = BONKERS_TIME;
    do {
        const double begin = b->now;
        double width = s->width > 0 ? s->width : first_width(b);
        if (width == INFINITY)
            return idle(b, until);
        s->count = how_many(b, width, until, limit);
        int tries = 4;
        while (tries > 0 && !try_slabs(b, begin, width, until)) {
            if (s->count > 1)
                s->alone = s->wary += s->wary < WARY ? s->wary + 1 : 0;
            else if (s->crowded)
                tries = 0;
            else
                --tries;
            if (s->count == 1)
                width /= 4;
            s->slabs = s->count = 1;
        }
        const double end = s->slab[s->count].end;
        const uint64_t collisions = collisions_of(b);
        if (tries > 0 && !holds_the_end(b, collisions, limit)) {
            b->collisions += collisions;
            b->now = end;
            adapt(b, (end - begin) / (double)s->count, collisions);
        } else {
            undo_all(b);
            b->now = begin;
            s->slabs = 1;
            if (s->count == 1)
                stop = run_slab_by_heap(b, end, limit);
        }
    } while (stop == BONKERS_TIME && b->now < until);
    return stop;
}

/* By how much rounding may misplace bodies i-1 and i, m. */
static double rounding(const struct bonkers *b, size_t i)
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

const char *const bonkers_engine_names[BONKERS_ENGINES + 1] = {
    "auto", "naive", "scan", "heap", "slab", NULL};

static bool create(struct bonkers *b, size_t movers, double restitution,
                   enum bonkers_engine engine, bool points)
{
    *b = (struct bonkers){.gaps = movers + 1, .restitution = restitution};
    b->engine = engine != BONKERS_AUTO      ? engine
                : movers <= BONKERS_SCANNED ? BONKERS_SCAN
                                            : BONKERS_SLAB;
    bool enough = (b->body = calloc(movers + 2, sizeof *b->body)) &&
                  (b->due = malloc(b->gaps * sizeof *b->due));
    if (!points)
        enough =
            enough && (b->shift = malloc((movers + 2) * sizeof *b->shift));
    if (restitution < 1)
        enough =
            enough && (b->repeats = calloc(b->gaps, sizeof *b->repeats));
    if (b->engine == BONKERS_SCAN || b->engine == BONKERS_SLAB)
        enough =
            enough && (b->fraction = malloc(b->gaps * sizeof *b->fraction));
    if (b->engine == BONKERS_HEAP)
        enough = enough && schedule_create(&b->schedule, b->gaps, b->gaps);
    if (b->engine == BONKERS_SLAB)
        enough = enough &&
                 schedule_create(&b->schedule, b->gaps,
                                 b->gaps < CROWD ? b->gaps : CROWD) &&
                 (b->slab = create_slabs(b));
    if (!enough) {
        bonkers_free(b);
        return false;
    }
    return true;
}

bool bonkers_create(struct bonkers *b, size_t movers, double restitution,
                    enum bonkers_engine engine)
{
    return create(b, movers, restitution, engine, false);
}

void bonkers_free(struct bonkers *b)
{
    free_slabs(b->slab);
    free(b->body);
    free(b->due);
    free(b->shift);
    free(b->repeats);
    free(b->fraction);
    schedule_free(&b->schedule);
    *b = (struct bonkers){0};
}

/* Subtracts the s_i of (2.2, eq:rods) from the positions. The radii may
   stand where the s_i will. */
static void take_out_radii(struct bonkers *b, const double radius[])
{
    double sum = 0;
    for (size_t i = 0; i <= b->gaps; ++i) {
        const double r = radius[i];
        b->shift[i] = sum + r;
        b->body[i].x -= b->shift[i];
        sum += 2 * r;
    }
}

size_t bonkers_start(struct bonkers *b, const double radius[])
{
    b->extent = 0;
    for (size_t i = 0; i <= b->gaps; ++i)
        if (isfinite(b->body[i].x))
            b->extent = fmax(b->extent, fabs(b->body[i].x));
    if (radius) {
        take_out_radii(b, radius);
    } else {
        free(b->shift);
        b->shift = NULL;
    }
    for (size_t i = 0; i < b->gaps; ++i) {
        struct bonkers_body *left = &b->body[i], *right = left + 1;
        if (!(right->x - left->x >= -rounding(b, i + 1)))
            return i;
        if (right->x < left->x)
            right->x = left->x; /* they touch, but for rounding */
        b->due[i] = b->gravity > 0 ? time_of_fall(b, i) : time_of_gap(left);
        if (b->fraction)
            b->fraction[i] = fraction(b, i);
        if (b->engine == BONKERS_HEAP)
            reschedule(b, i);
    }
    return b->gaps;
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
                   ? run_naive_falling(b, until, collisions)
                   : set_clocks(b, run_naive(b, until, collisions));
    case BONKERS_SCAN: return run_scan(b, until, collisions);
    case BONKERS_HEAP: return run_heap(b, until, collisions);
    default: return run_slabs(b, until, collisions);
    }
}

bool bonkers_begin(struct bonkers *b, const struct start *s,
                   double restitution, enum bonkers_engine engine,
                   size_t *wrong)
{
    bool points = true;
    for (size_t i = 0; i < s->movers; ++i)
        points = points && s->radius[i] == 0;
    if (!create(b, s->movers, restitution, engine, points))
        return false;
    b->gravity = s->gravity;
    b->body[0].x = s->wall[0];
    b->body[b->gaps].x = s->wall[1];
    for (size_t i = 0; i < s->movers; ++i)
        b->body[i + 1] =
            (struct bonkers_body){s->x[i], s->v[i], 0, 1 / s->mass[i]};
    if (!points) {
        memcpy(b->shift + 1, s->radius, s->movers * sizeof *b->shift);
        b->shift[0] = b->shift[b->gaps] = 0;
    }
    *wrong = bonkers_start(b, b->shift);
    return true;
}

void bonkers_settle(struct bonkers *b)
{
    for (size_t i = 0; i <= b->gaps; ++i) {
        b->body[i] = body_at(b, i, b->now);
        b->body[i].x += b->shift ? b->shift[i] : 0;
        b->body[i].since = 0;
        if (b->repeats && i < b->gaps)
            b->repeats[i] = 0;
    }
    b->now = 0;
    b->collisions = 0;
    schedule_clear(&b->schedule);
}

void bonkers_state(struct bonkers *b, double x[], double v[])
{
    const double right = b->body[b->gaps].x;
    double last = b->body[0].x;
    for (size_t i = 0; i <= b->gaps; ++i) {
        const struct bonkers_body a = body_at(b, i, b->now);
        if (a.x < last && a.x < last - rounding(b, i))
            ++b->disorder;
        last = a.x < last ? last : a.x > right ? right : a.x;
        x[i] = b->shift ? last + b->shift[i] : last;
        v[i] = a.v;
    }
}

bool bonkers_is_still(const struct bonkers *b)
{
    for (size_t i = 0; i < b->gaps; ++i)
        if (b->gravity > 0 ? time_of_fall(b, i) < INFINITY
                           : b->body[i].v > b->body[i + 1].v &&
                                 b->body[i + 1].x - b->body[i].x < INFINITY)
            return false;
    return true;
}

bool bonkers_is_cold(const struct bonkers *b)
{
    for (size_t i = 0; i < b->gaps; ++i)
        if (b->repeats && b->repeats[i] >= patience(b))
            return false;
    return true;
}

double bonkers_energy(const struct bonkers *b)
{
    const double low = b->body[0].x, floor = low > -INFINITY ? low : 0;
    double sum = 0;
    for (size_t i = 1; i < b->gaps; ++i) {
        const struct bonkers_body *a = &b->body[i];
        sum += (a->v * a->v + 2 * b->gravity * (a->x - floor)) / a->im;
    }
    return sum / 2;
}
