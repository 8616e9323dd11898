/* Which of many events comes first. */
#ifndef SCHEDULE_H
#define SCHEDULE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Returns the index of the smallest of n times, the first of equal ones.
   Requires n > 0. Reads all of them. */
size_t schedule_scan(const double time[], size_t n);

struct schedule_entry {
    double time;
    uint32_t event;
};

/* Some of the events 0 to size-1, the earliest on top. To be read:
   heap[0] when count > 0. */
struct schedule {
    struct schedule_entry *heap; /* ordered as (2.5, eq:heap) demands */
    uint32_t *place;             /* of each event in the heap */
    size_t size, count;
};

/* Prepares an empty schedule for events 0 to size-1, `room` of them at a
   time. Returns false, with nothing to free, when there is no memory. */
bool schedule_create(struct schedule *s, size_t size, size_t room);
void schedule_free(struct schedule *s);

/* Gives the event this time, whether it was in the schedule or not. Cost:
   at most of the order log2(count). */
void schedule_put(struct schedule *s, size_t event, double time);

/* Takes the event out, if it was in. */
void schedule_drop(struct schedule *s, size_t event);

/* Takes out the earliest event and returns it. Requires count > 0. */
size_t schedule_take(struct schedule *s);

/* Takes out all events. Cost: of the order of count. */
void schedule_clear(struct schedule *s);

#endif
