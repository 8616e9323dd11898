/* A list of future events that knows the earliest, day by day. */
#ifndef CALENDAR_H
#define CALENDAR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CALENDAR_NONE UINT32_MAX /* no event */

/* What one of the numbered events has to remember. */
struct calendar_event {
    double time;             /* s; INFINITY: in no list */
    uint32_t next, previous; /* neighbours in the list of its day */
    uint32_t partner;        /* the caller's: with whom */
    uint32_t version;        /* the caller's: how the partner was then */
};

/* Events 0 to size-1, each with a time or none, in lists one day wide that
   end with the number size. Behind the last day is one list of all that
   comes later. */
struct calendar {
    struct calendar_event *event;
    uint32_t *day; /* the first event of each day; [days]: later */
    size_t size, days, today;
    size_t count;    /* events that have a time */
    double begin;    /* of day 0, s */
    double width;    /* of a day, s */
    uint64_t asked;  /* how often for the first event, since the turn */
    uint64_t looked; /* at how many events of a day for that */
};

/* Prepares a calendar for events 0 to size-1 that starts at the time
   begin, s, none of them with a time yet. width, s: a guess of how long a
   day should be; the calendar mends it. Returns false, with nothing to
   free, when there is no memory. Requires 0 < size < 2^31 - 64,
   width > 0. */
bool calendar_create(struct calendar *c, size_t size, double begin,
                     double width);
void calendar_free(struct calendar *c);

/* Gives an event a time, s, whether it had one or not; INFINITY takes it
   out. Cost: the same for any size. Source: (7.17, eq:day). */
void calendar_put(struct calendar *c, uint32_t event, double time);

/* Returns the earliest event, CALENDAR_NONE if none has a time. Of events
   at the same time, each with its partner, it returns the first in order of
   the smaller number of the two, then of the larger. */
uint32_t calendar_first(struct calendar *c);

#endif
