/* What crosses the border of exercise 05c: see examiner/border.h. The disks
   stay outside, and what the student does to them is asked for. To fly, to
   collide and to record give no answer, and so many of them cross at once:
   all at the next question, or when there is no more room. */
/* place: none */

#include "examiner/border.h"
#include <stdlib.h>

struct box;

double box_next(struct box *box);
void box_fly(struct box *box, double time);
void box_collide(struct box *box);
void box_record(struct box *box, double t);
void box_run(struct box *box, double tick, size_t samples);

/* What may be asked; and what is done, which is nothing where the list of
   deeds is not full. */
enum { DO, NEXT };
enum { NOTHING, FLY, COLLIDE, RECORD };

enum { ROOM = 64 };

struct deeds {
    int what[ROOM];
    double time[ROOM];
};

static void move_deeds(struct deeds *d)
{
    border_ints(d->what, ROOM);
    border_doubles(d->time, ROOM);
}

#ifdef BORDER_INSIDE

struct box {
    size_t used;
    struct deeds deeds;
};

static void clear(struct box *box)
{
    box->used = 0;
    for (size_t k = 0; k < ROOM; ++k) {
        box->deeds.what[k] = NOTHING;
        box->deeds.time[k] = 0.0;
    }
}

static void send(struct box *box)
{
    border_ask(DO);
    move_deeds(&box->deeds);
    border_hear();
    clear(box);
}

static void add(struct box *box, int what, double time)
{
    box->deeds.what[box->used] = what;
    box->deeds.time[box->used++] = time;
    if (box->used == ROOM)
        send(box);
}

double box_next(struct box *box)
{
    double time;
    border_ask(NEXT);
    move_deeds(&box->deeds);
    border_hear();
    border_doubles(&time, 1);
    clear(box);
    return time;
}

void box_fly(struct box *box, double time)
{
    add(box, FLY, time);
}

void box_collide(struct box *box)
{
    add(box, COLLIDE, 0.0);
}

void box_record(struct box *box, double t)
{
    add(box, RECORD, t);
}

void border_answer(void)
{
    struct box *box = border_memory(sizeof *box);
    double tick;
    size_t samples;
    border_doubles(&tick, 1);
    border_sizes(&samples, 1);
    clear(box);
    box_run(box, tick, samples);
    send(box);
    free(box);
    border_reply();
}

#else

/* The box of the call that is under way. */
static struct box *present;

static void do_all(const struct deeds *d)
{
    for (size_t k = 0; k < ROOM; ++k)
        switch (d->what[k]) {
        case FLY: box_fly(present, d->time[k]); break;
        case COLLIDE: box_collide(present); break;
        case RECORD: box_record(present, d->time[k]); break;
        default: break;
        }
}

void border_heed(int which)
{
    struct deeds d;
    double time;
    move_deeds(&d);
    do_all(&d);
    border_tell();
    if (which == NEXT) {
        time = box_next(present);
        border_doubles(&time, 1);
    }
}

void box_run(struct box *box, double tick, size_t samples)
{
    present = box;
    border_call();
    border_doubles(&tick, 1);
    border_sizes(&samples, 1);
    border_wait();
}

#endif
