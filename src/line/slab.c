/* The slab engine: distant bodies run independently for a short time. */

/* A slab is an interval of time. The collisions in a slab form islands,
   which are groups of neighbouring gaps. The engine passes along the line
   once per slab and runs one island after another. Chapter 2 (section Small
   islands of time) proves that the result equals that of the scan engine to
   the last bit if islands are separated by at least two gaps without
   collisions (2.6, eq:islands). Islands that come closer to each other are
   undone by means of a log, and run again as a single island. */
#include "line/slab.h"

#include "line/engine.h"
#include "line/gap.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* An entry of the log: the values that a collision of `gap` overwrites.
   These are the positions, velocities and times of two bodies, and the
   counter of the gap. The times when gaps close are not stored, since
   recomputing them from the bodies gives the same bits. */
struct log_entry {
    double x[2], v[2], since[2];
    uint32_t gap, repeats;
};

/* A group of neighbouring gaps, from first to last. Its entries in the log
   begin at index `start` and end before the start of the next island. */
struct island {
    uint32_t first, last;
    size_t start;
};

/* The progress of a slab along the line, from left to right. A line of a
   million bodies does not fit into a cache, and loading it from memory for
   every slab would take as long as the collisions. So up to SLABS slabs
   advance together, each BLOCK gaps behind the one before it. They share
   the bodies that the first slab has loaded. */
struct slab {
    double end;  /* end of the interval of time, s */
    size_t next; /* first gap that is not finished */
    struct log_entry *log;
    size_t logged, log_size;
    struct island *island;
    size_t islands, island_size;
    uint64_t collisions; /* collisions whose log entries were dropped */
};

enum {
    SLABS = 16,     /* largest number of slabs in progress at once */
    BLOCK = 256,    /* number of gaps between one slab and the next */
    MOST_ALONE = 63 /* largest number of slabs run alone after a failure */
};

/* The data of a body that collisions change, in m, m/s and s. */
struct motion {
    double x, v, since;
};

/* The state of the engine. slab[0] runs no collisions: it advances first
   and saves the bodies. slab[1] to slab[count] run collisions. slab[count +
   1] only marks how far slab[count] has finished. */
struct bonkers_slab {
    double width;         /* duration of the next slabs, s; 0 if unknown */
    size_t slabs, count;  /* slabs to run next; slabs in progress */
    size_t alone;         /* number of slabs still to be run alone */
    size_t after_failure; /* slabs run alone after the last failure */
    struct slab slab[SLABS + 2];
    struct motion *saved;
    uint32_t *repeats; /* saved copy of b->repeats */
    uint64_t redone;   /* collisions undone in these slabs */
    bool collapse;     /* the run must end as BONKERS_COLLAPSE */
    bool failed;       /* all slabs must be undone */
    bool crowded;      /* an island has over SLAB_WAITING due gaps */
};

void slab_free(struct bonkers_slab *s)
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

struct bonkers_slab *slab_create(const struct bonkers *b)
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
    slab_free(s);
    return NULL;
}

static struct log_entry entry_of(const struct bonkers *b, size_t i)
{
    const struct bonkers_body *l = &b->body[i], *r = l + 1;
    return (struct log_entry){{l->x, r->x},
                              {l->v, r->v},
                              {l->since, r->since},
                              (uint32_t)i,
                              b->repeats ? b->repeats[i] : 0};
}

static void undo(struct bonkers *b, const struct log_entry *r)
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

/* Undoes the logged collisions in reverse order, back to entry `start`, so
   that each entry finds its two bodies as its collision left them. Adds the
   number of undone collisions to redone, since a slab that undoes many
   collisions is too long. */
static void undo_to(struct bonkers *b, struct slab *s, size_t start)
{
    b->slab->redone += s->logged - start;
    while (s->logged > start)
        undo(b, &s->log[--s->logged]);
}

/* Makes room in an array for another item of `size` bytes. Returns false if
   memory runs out. */
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

/* Returns the last gap of an island that has reached gap `last`. The island
   extends to the right while one of the next two gaps is due by `end`. */
static size_t end_of_chain(const struct bonkers *b, size_t last, double end)
{
    for (;;)
        if (last + 2 < b->gaps && b->due[last + 2] <= end)
            last += 2;
        else if (last + 1 < b->gaps && b->due[last + 1] <= end)
            last += 1;
        else
            return last;
}

/* Schedules the gaps from first to last that are due by `end`. Removes the
   earliest from the schedule and returns it. */
static size_t schedule_due(struct bonkers *b, size_t first, size_t last,
                           double end)
{
    for (size_t k = first; k <= last && b->schedule.count < SLAB_WAITING;
         ++k)
        if (b->due[k] <= end)
            schedule_put(&b->schedule, k, b->due[k]);
    return schedule_take(&b->schedule);
}

/* Recomputes the times of gap i and its neighbours, and schedules the gaps
   that are now due. In most islands no gap is due again, so the schedule
   stays empty and costs nothing. */
static void renew_due(struct bonkers *b, size_t i, double end)
{
    size_t low, high;
    find_changed(b, i, &low, &high);
    for (size_t k = low; k <= high; ++k) {
        const double t = b->due[k] = time_due(b, k);
        if (t <= end)
            schedule_put(&b->schedule, k, t);
        else if (b->schedule.count > 0)
            schedule_drop(&b->schedule, k);
    }
}

/* Returns whether an island of gaps `first` to `last` would leave the range
   of gaps that only slab s may change. The island reads bodies up to
   `last` + 2, which slab s - 1 must have finished. It changes the time of
   gap `first` - 1, which slab s + 1 must not have read. Within this range
   every island runs as if the slabs ran one after another, and the proof of
   chapter 2 applies to each slab. */
static bool leaves_its_slab(const struct slab *s, size_t first, size_t last)
{
    const struct slab *before = s - 1, *behind = s + 1;
    return last + 3 > before->next ||
           (behind->next > 0 && first <= behind->next);
}

/* Returns whether the slab has logged, or all slabs have undone, far more
   collisions than there are gaps, as when a light ball bounces a million
   times between two heavy balls. The log would become enormous, so the slab
   is undone and tried again at a quarter of the width. */
static bool too_long(const struct bonkers *b, const struct slab *s)
{
    const size_t most = 8 * b->gaps + 65536;
    return s->logged > most || b->slab->redone > most;
}

/* Extends the island of gaps *first to *last by gap i if i is next to it.
   Returns false if the island is then too close (2.6, eq:islands) to a
   finished island on its left or to a due gap on its right. In the latter
   case sets *last to the due gap. Gap i + 1 needs no test: if it had been
   due, the island would have included it from the start. */
static bool keep_apart(const struct bonkers *b, const struct slab *s,
                       size_t i, size_t *first, size_t *last)
{
    if (i < *first) {
        *first = i;
        if (s->islands > 0 &&
            i <= s->island[s->islands - 1].last + (size_t)2)
            return false;
    } else if (i > *last) {
        *last = i;
        if (i + 2 < b->gaps && b->due[i + 2] <= s->end) {
            *last = i + 2;
            return false;
        }
    }
    return true;
}

/* Runs the collisions of the island of gaps *first to *last up to the end
   of the slab. keep_apart may extend the island. Returns false if the slabs
   have failed, or if the island is too close to another island and must be
   restarted. Each collision needs room for an entry in the log and for
   three gaps in the schedule. After a collapse the island stops, since the
   run ends before its next collision. */
static bool run_island(struct bonkers *b, struct slab *s, size_t *first,
                       size_t *last)
{
    const double end = s->end;
    size_t i = *first;
    if (*first < *last)
        i = schedule_due(b, *first, *last, end);
    for (;;) {
        if (!keep_apart(b, s, i, first, last))
            return false;
        b->slab->crowded |= b->schedule.count + 3 > SLAB_WAITING;
        if (b->slab->crowded || too_long(b, s) ||
            leaves_its_slab(s, *first, *last) ||
            !make_room((void **)&s->log, s->logged, &s->log_size,
                       sizeof *s->log)) {
            b->slab->failed = true;
            return false;
        }
        s->log[s->logged++] = entry_of(b, i);
        if (collide_gap(b, i)) {
            b->slab->collapse = true;
            schedule_clear(&b->schedule);
            renew(b, i);
            return true;
        }
        renew_due(b, i, end);
        if (b->schedule.count == 0)
            return true;
        i = schedule_take(&b->schedule);
    }
}

/* Runs the island that begins at gap `first`. Returns the next gap after it
   that may begin another island, or 0 if the slabs have failed. If the
   island comes too close to islands on its left, the collisions of all
   these islands are undone and run again as a single larger island. That
   island may in turn come too close to another one. Islands are logged from
   left to right, so the island to undo is always the last. */
static size_t add_island(struct bonkers *b, struct slab *s, size_t first)
{
    size_t start = s->logged, last = end_of_chain(b, first, s->end);
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
        last = end_of_chain(b, last, s->end);
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

/* Saves the bodies and the counters of gaps `from` to `to` - 1, which also
   loads them into the cache. Prefetches the next block. With a compiler
   without __builtin_prefetch, large lines are slower. */
static void save(struct bonkers *b, size_t from, size_t to)
{
    const size_t count = to - from + (to == b->gaps);
    struct bonkers_slab *s = b->slab;
    for (size_t i = from; i < from + count; ++i) {
        const struct bonkers_body *a = &b->body[i];
        s->saved[i] = (struct motion){a->x, a->v, a->since};
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

/* Restores all saved bodies and counters. Recomputes the times of the
   gaps. */
static void undo_all(struct bonkers *b)
{
    const struct bonkers_slab *s = b->slab;
    const size_t next = s->slab[0].next;
    const size_t gaps = next < b->gaps ? next : b->gaps;
    for (size_t i = 0; i < gaps + (next > gaps); ++i) {
        const struct motion *a = &s->saved[i];
        b->body[i] =
            (struct bonkers_body){a->x, a->v, a->since, b->body[i].im};
    }
    if (b->repeats)
        memcpy(b->repeats, s->repeats, gaps * sizeof *b->repeats);
    for (size_t i = 0; i < gaps; ++i)
        b->due[i] = time_due(b, i);
}

/* Drops the log entries of islands that the next slab has passed, since
   these islands are never undone individually. Does this only if the log
   has at least MANY entries, since moving the remaining entries costs
   time. */
static void drop_safe_entries(struct slab *s)
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

/* Runs the islands of slab s that begin in gaps `from` to `to` - 1. Returns
   false if the slabs have failed and must all be undone. The list of due
   gaps is made without a branch, which would be mispredicted at every
   island. Each gap is written to the list, but the index advances only if
   the gap is due. */
static bool run_block(struct bonkers *b, struct slab *s, size_t from,
                      size_t to)
{
    const double end = s->end;
    size_t next = s->next;
    uint32_t due[BLOCK];
    size_t count = 0;
    for (size_t i = next > from ? next : from; i < to; ++i) {
        due[count] = (uint32_t)i;
        count += b->due[i] <= end;
    }
    drop_safe_entries(s);
    for (size_t k = 0; k < count; ++k)
        if (due[k] >= next && !(next = add_island(b, s, due[k])))
            return false;
    s->next = to == b->gaps ? SIZE_MAX : next > to ? next : to;
    return true;
}

/* Advances a slab by a block. Returns false if the slabs have failed. */
static bool advance(struct bonkers *b, size_t slab, size_t block)
{
    struct slab *s = &b->slab->slab[slab];
    const size_t from = block * BLOCK;
    const size_t to = from + BLOCK < b->gaps ? from + BLOCK : b->gaps;
    if (from >= b->gaps)
        return true;
    if (slab > 0 && slab <= b->slab->count)
        return run_block(b, s, from, to);
    if (slab == 0 && b->slab->count > 1)
        save(b, from, to);
    else if (b->slab->count > 1)
        s->next = to;
    return true;
}

/* Runs every island of all slabs. Returns false if the slabs have failed
   and must be undone. A slab that runs alone may have islands of any
   length. */
static bool run_islands(struct bonkers *b)
{
    const size_t blocks = (b->gaps + BLOCK - 1) / BLOCK;
    const size_t slabs = b->slab->count;
    if (slabs == 1)
        save(b, 0, b->gaps);
    for (size_t block = 0; block < blocks + slabs; ++block)
        for (size_t k = 0; k <= slabs + 1 && k <= block; ++k)
            if (!advance(b, k, block - k))
                return false;
    return true;
}

/* Returns the number of collisions that a slab should have. With fewer
   collisions, most of the time is spent on passing along the line. With
   more collisions, islands often come too close to each other, and many
   collisions are repeated. Three collisions for every twenty gaps proved
   fastest. */
static double collisions_wanted(const struct bonkers *b)
{
    return 0.15 * (double)b->gaps + 1;
}

/* Chooses the width and number of the next slabs from the width and the
   collisions of the last slabs. This choice does not affect the results.
   The width changes at most by a factor of two, or becomes 0 (unknown) if
   there were no collisions. If the width was about right, the number of
   slabs doubles. When several slabs fail together, they will probably fail
   again: for example, a fast ball among many at rest starts a wave that is
   too long for one of several slabs. So after a failure one slab runs
   alone, after the next failure three, then seven, up to MOST_ALONE. This
   number is halved whenever SLABS slabs have succeeded together. */
static void adapt_width(struct bonkers *b, double width,
                        uint64_t collisions)
{
    struct bonkers_slab *s = b->slab;
    const double fill =
        (double)collisions / (double)s->count / collisions_wanted(b);
    s->width = collisions == 0 ? 0
               : fill < 0.5    ? 2 * width
               : fill > 2      ? 0.5 * width
                               : width / fill;
    if (s->count == SLABS)
        s->after_failure /= 2;
    s->slabs = fill < 0.5 || fill > 2 || s->alone > 0 ? 1
               : s->slabs < SLABS                     ? 2 * s->slabs
                                                      : SLABS;
    s->alone -= s->alone > 0;
}

/* Returns a first guess of the width (in s), which adapt_width corrects:
   twice the time to the next collision, or INFINITY if there is no
   collision. Late in a run this may be shorter than the clock can resolve,
   so the width is at least 1e-12 of the clock reading. */
static double first_width(const struct bonkers *b)
{
    const double wait = b->due[schedule_scan(b->due, b->gaps)] - b->now;
    return wait == INFINITY ? wait
                            : fmin(fmax(2 * wait, 1e-12 * b->now), DBL_MAX);
}

/* Runs slabs of this width (in s) from the time `begin`, but not beyond
   `until`. If the slabs fail, undoes all of their collisions and returns
   false. */
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

/* Returns the number of collisions in the slabs in progress. */
static uint64_t collisions_of(const struct bonkers *b)
{
    uint64_t sum = 0;
    for (size_t k = 1; k <= b->slab->count; ++k)
        sum += b->slab->slab[k].collisions + b->slab->slab[k].logged;
    return sum;
}

/* Returns whether the run may have to stop within the slabs in progress.
   Slabs do not run their collisions in order of time, so they cannot stop
   at a given collision. */
static bool holds_the_end(const struct bonkers *b, uint64_t collisions,
                          uint64_t limit)
{
    return b->slab->collapse || collisions >= limit - b->collisions;
}

/* Runs up to `end` with the heap engine. This engine counts collisions in
   order of time and can handle any number of simultaneous collisions, as
   when a thousand touching balls are struck. The heap needs room for every
   gap. It uses the memory of the saved bodies, which have already been
   restored. */
static enum bonkers_stop run_slab_by_heap(struct bonkers *b, double end,
                                          uint64_t limit)
{
    const struct schedule islands = b->schedule;
    b->schedule.heap = (void *)b->slab->saved;
    for (size_t i = 0; i < b->gaps; ++i)
        engine_reschedule(b, i);
    const enum bonkers_stop stop = engine_run_heap(b, end, limit);
    schedule_clear(&b->schedule);
    b->schedule = islands;
    b->slab->width = 0; /* unknown */
    return stop;
}

/* Returns the number of slabs to run next. This is one if the width is a
   guess or if the run is near its end. */
static size_t slabs_to_go(const struct bonkers *b, double width,
                          double until, uint64_t limit)
{
    const double time = (until - b->now) / width;
    const double collisions =
        (double)(limit - b->collisions) / (2 * collisions_wanted(b));
    const double most =
        fmin(fmin(ceil(time), collisions), (double)b->slab->slabs);
    return b->slab->width > 0 && most > 1 ? (size_t)most : 1;
}

/* If several slabs fail together, a single slab is tried. Each time a
   single slab fails, its width is divided by four. After four failures the
   heap engine takes over, since each attempt costs as much as a slab. If
   too many gaps are due at the same time, a shorter slab would not help,
   and the heap engine takes over at once. The heap engine also runs the
   slab with the last requested collision, which happens only once in a
   run. */
enum bonkers_stop slab_run(struct bonkers *b, double until, uint64_t limit)
{
    struct bonkers_slab *s = b->slab;
    enum bonkers_stop stop = BONKERS_TIME;
    do {
        const double begin = b->now;
        double width = s->width > 0 ? s->width : first_width(b);
        if (width == INFINITY)
            return engine_idle(b, until);
        s->count = slabs_to_go(b, width, until, limit);
        int tries = 4;
        while (tries > 0 && !try_slabs(b, begin, width, until)) {
            if (s->count > 1)
                s->alone = s->after_failure += s->after_failure < MOST_ALONE
                                                   ? s->after_failure + 1
                                                   : 0;
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
            adapt_width(b, (end - begin) / (double)s->count, collisions);
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
