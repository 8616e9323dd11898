/* From chapters/07-gas.nw: edit there, then run make tangle. */
/* checksum 2987571324 of the lines below */
/* A calendar queue: days that are linked lists of a few events. */
#include "box/calendar.h"

#include <math.h>
#include <stdlib.h>

enum {
    BUSY = 2,   /* wanted number of events in a day */
    CROWDED = 8 /* events examined per call if days are too wide */
};

/* The bit of `previous` that marks the first event of a list. The other
   bits then contain the number of the day. */
#define DAY ((uint32_t)1 << 31)

void calendar_free(struct calendar *c)
{
    free(c->event);
    free(c->day);
    *c = (struct calendar){0};
}

bool calendar_create(struct calendar *c, size_t size, double begin,
                     double width)
{
    const size_t days = size + 64;
    *c = (struct calendar){
        .size = size, .days = days, .begin = begin, .width = width};
    c->event = malloc((size + 1) * sizeof *c->event);
    c->day = malloc((days + 1) * sizeof *c->day);
    if (!c->event || !c->day) {
        calendar_free(c);
        return false;
    }
    const struct calendar_event none = {.time = INFINITY,
                                        .next = (uint32_t)size};
    for (size_t i = 0; i <= size; ++i)
        c->event[i] = none;
    for (size_t i = 0; i <= days; ++i)
        c->day[i] = (uint32_t)size;
    return true;
}

static size_t day_of(const struct calendar *c, double time)
{
    const double day = (time - c->begin) / c->width; /* (7.17, eq:day) */
    if (!(day < (double)c->days))
        return c->days;
    return day > (double)c->today ? (size_t)day : c->today;
}

static void put_in(struct calendar *c, uint32_t e)
{
    struct calendar_event *x = &c->event[e];
    const size_t day = day_of(c, x->time);
    x->next = c->day[day];
    x->previous = DAY + (uint32_t)day;
    c->event[x->next].previous = e;
    c->day[day] = e;
}

static void take_out(struct calendar *c, uint32_t e)
{
    const struct calendar_event *x = &c->event[e];
    uint32_t *link = x->previous & DAY ? &c->day[x->previous - DAY]
                                       : &c->event[x->previous].next;
    c->event[x->next].previous = x->previous;
    *link = x->next;
}

void calendar_put(struct calendar *c, uint32_t e, double time)
{
    if (c->event[e].time < INFINITY) {
        take_out(c, e);
        --c->count;
    }
    c->event[e].time = time;
    if (time < INFINITY) {
        put_in(c, e);
        ++c->count;
    }
}

static bool before(const struct calendar *c, uint32_t a, uint32_t b)
{
    const struct calendar_event *x = &c->event[a], *y = &c->event[b];
    if (x->time != y->time)
        return x->time < y->time;
    const bool fine = a < x->partner, good = b < y->partner;
    const uint32_t low = fine ? a : x->partner,
                   high = fine ? x->partner : a;
    const uint32_t lesser = good ? b : y->partner;
    return low != lesser ? low < lesser : high < (good ? y->partner : b);
}

static uint32_t earliest_in(struct calendar *c, uint32_t list)
{
    uint32_t first = list;
    for (uint32_t e = c->event[list].next; e < c->size;
         e = c->event[e].next, ++c->looked)
        if (before(c, e, first))
            first = e;
    return first;
}

static void turn(struct calendar *c)
{
    uint32_t e = c->day[c->days];
    c->begin = fmax(c->begin + c->width * (double)c->days,
                    c->event[earliest_in(c, e)].time);
    c->width *= fmax(
        0.25, fmin(4, BUSY * (double)c->days / (double)(c->asked + 1)));
    c->day[c->days] = (uint32_t)c->size;
    c->today = 0;
    c->asked = c->looked = 0;
    while (e < c->size) {
        const uint32_t next = c->event[e].next;
        put_in(c, e);
        e = next;
    }
}

static void shorten(struct calendar *c)
{
    const double today = c->begin + c->width * (double)c->today;
    c->asked = c->looked = 0;
    if (!(today + c->width / 4 > today))
        return; /* shorter days would not change the clock */
    c->begin = today;
    c->width /= 4;
    c->today = 0;
    for (size_t i = 0; i <= c->days; ++i)
        c->day[i] = (uint32_t)c->size;
    for (uint32_t e = 0; e < c->size; ++e)
        if (c->event[e].time < INFINITY)
            put_in(c, e);
}

uint32_t calendar_first(struct calendar *c)
{
    if (c->count == 0)
        return CALENDAR_NONE;
    if (c->looked > CROWDED * (c->asked + c->days))
        shorten(c);
    while (c->day[c->today] == c->size)
        if (++c->today == c->days)
            turn(c);
    ++c->asked;
    return earliest_in(c, c->day[c->today]);
}
