/* From chapters/02-bonkers.nw: edit there, then run make tangle. */
/* checksum 4148645003 of the lines below */
/* Finds the earliest event by comparing all times, or with a heap. */
#include "line/schedule.h"

#include <stdlib.h>

size_t schedule_scan(const double time[], size_t n)
{
    size_t first = 0;
    double earliest = time[0];
    for (size_t i = 1; i < n; ++i)
        if (time[i] < earliest) {
            earliest = time[i];
            first = i;
        }
    return first;
}

/* Returns whether entry a comes before entry b: at equal times the event
   with the smaller number comes first. */
static bool earlier(struct schedule_entry a, struct schedule_entry b)
{
    return (a.time < b.time) | ((a.time == b.time) & (a.event < b.event));
}

static void put_at(struct schedule *s, size_t k, struct schedule_entry e)
{
    s->heap[k] = e;
    s->place[e.event] = (uint32_t)k;
}

static void rise(struct schedule *s, size_t k, struct schedule_entry e)
{
    for (; k > 0 && earlier(e, s->heap[(k - 1) / 2]); k = (k - 1) / 2)
        put_at(s, k, s->heap[(k - 1) / 2]);
    put_at(s, k, e);
}

static void sink(struct schedule *s, size_t k, struct schedule_entry e)
{
    for (size_t child; (child = 2 * k + 1) < s->count; k = child) {
        if (child + 1 < s->count)
            child += earlier(s->heap[child + 1], s->heap[child]);
        if (!earlier(s->heap[child], e))
            break;
        put_at(s, k, s->heap[child]);
    }
    put_at(s, k, e);
}

static void settle(struct schedule *s, size_t k, struct schedule_entry e)
{
    if (k > 0 && earlier(e, s->heap[(k - 1) / 2]))
        rise(s, k, e);
    else
        sink(s, k, e);
}

enum { ABSENT = -1 };

bool schedule_create(struct schedule *s, size_t size, size_t room)
{
    *s = (struct schedule){.size = size};
    s->heap = malloc(room * sizeof *s->heap);
    s->place = malloc(size * sizeof *s->place);
    if (!s->heap || !s->place) {
        schedule_free(s);
        return false;
    }
    for (size_t i = 0; i < size; ++i)
        s->place[i] = (uint32_t)ABSENT;
    return true;
}

void schedule_free(struct schedule *s)
{
    free(s->heap);
    free(s->place);
    *s = (struct schedule){0};
}

void schedule_put(struct schedule *s, size_t event, double time)
{
    const uint32_t place = s->place[event];
    const size_t k = place == (uint32_t)ABSENT ? s->count++ : place;
    settle(s, k, (struct schedule_entry){time, (uint32_t)event});
}

void schedule_drop(struct schedule *s, size_t event)
{
    const uint32_t k = s->place[event];
    if (k == (uint32_t)ABSENT)
        return;
    s->place[event] = (uint32_t)ABSENT;
    --s->count;
    if (k < s->count)
        settle(s, k, s->heap[s->count]);
}

size_t schedule_take(struct schedule *s)
{
    const size_t event = s->heap[0].event;
    schedule_drop(s, event);
    return event;
}

void schedule_clear(struct schedule *s)
{
    for (size_t k = 0; k < s->count; ++k)
        s->place[s->heap[k].event] = (uint32_t)ABSENT;
    s->count = 0;
}
