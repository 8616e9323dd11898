/* Finds the earliest of many events. */
#ifndef SCHEDULE_H
#define SCHEDULE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Returns the index of the smallest of n times, or the first of equal
   times. Requires n > 0. The cost is proportional to n. */
size_t schedule_scan(const double time[], size_t n);

struct schedule_entry {
    double time;
    uint32_t event;
};

/* A heap of events with numbers from 0 to size - 1. heap[0] is the earliest
   event, and may be read if count > 0. */
struct schedule {
    struct schedule_entry *heap; /* ordered by (2.5, eq:heap) */
    uint32_t *place;             /* index of each event in heap */
    size_t size, count;
};

/* Prepares an empty schedule for the events 0 to size - 1. It can contain
   `room` events at once. Returns false, with nothing to free, if memory
   runs out. */
bool schedule_create(struct schedule *s, size_t size, size_t room);
void schedule_free(struct schedule *s);

/* Sets the time of an event. Adds the event if it is not in the schedule.
   The cost is at most of the order of log2(count). */
void schedule_put(struct schedule *s, size_t event, double time);

/* Removes an event; does nothing if it is not in the schedule. */
void schedule_drop(struct schedule *s, size_t event);

/* Removes the earliest event and returns it. Requires count > 0. */
size_t schedule_take(struct schedule *s);

/* Removes all events. The cost is of the order of count. */
void schedule_clear(struct schedule *s);

#endif
