/* A calendar queue: stores future events by day and finds the earliest. */
#ifndef CALENDAR_H
#define CALENDAR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CALENDAR_NONE UINT32_MAX /* no event */

/* One of the numbered events. */
struct calendar_event {
    double time;             /* s; INFINITY: not in the calendar */
    uint32_t next, previous; /* neighbours in the list of its day */
    uint32_t partner;        /* for the caller: a disk or a wall */
    uint32_t version;        /* for the caller: to find stale events */
};

/* Events 0 to size - 1, with or without a time. The events of a day are in
   a linked list, whose last `next` is `size`. All events after the last day
   are in another list. */
struct calendar {
    struct calendar_event *event;
    uint32_t *day; /* first event of each day; day[days]: later events */
    size_t size, days, today;
    size_t count;    /* events that have a time */
    double begin;    /* time when day 0 begins, s */
    double width;    /* length of a day, s */
    uint64_t asked;  /* calls of calendar_first since the last reset */
    uint64_t looked; /* events that these calls examined */
};

/* Prepares a calendar for the events 0 to size - 1, none of which has a
   time yet. `begin` is the time when the calendar starts, s. `width` (in
   s) is a first guess of the length of a day, which the calendar adapts.
   Returns false, with nothing to free, if memory runs out. Requires 0 <
   size < 2^31 - 64, width > 0. */
bool calendar_create(struct calendar *c, size_t size, double begin,
                     double width);
void calendar_free(struct calendar *c);

/* Gives an event a new time, s. INFINITY removes it from the calendar. The
   cost does not depend on the number of events (7.17, eq:day). */
void calendar_put(struct calendar *c, uint32_t event, double time);

/* Returns the earliest event, or CALENDAR_NONE if no event has a time. Each
   event forms a pair of numbers with its partner. Events at the same time
   are ordered by the smaller number of the pair, then by the larger. */
uint32_t calendar_first(struct calendar *c);

#endif
