/* The remote calls of exercise 05c: see examiner/remote.h. The disks
   stay outside. The box has a copy of them, for the questions of the
   student's loop, which are thousands; and a list of all that the loop does
   and asks. From time to time the list crosses, and outside it is done all
   over again: what becomes of the copy changes nothing there. */
/* output: none */

#include "examiner/remote.h"
#include <stdlib.h>

struct box;

double box_next(struct box *box);
void box_fly(struct box *box, double time);
void box_collide(struct box *box);
void box_record(struct box *box, double t);
void box_run(struct box *box, double tick, size_t samples);

/* What a box begins with, in the suite, too, and the physics. */
#define ONLY_PHYSICS
#include "suite.c"

static void move_disks(struct disks *d)
{
    remote_sizes(&d->n, 1);
    remote_doubles(d->length, 2);
    remote_doubles(&d->radius, 1);
    for (size_t i = 0; i < DISKS; ++i) {
        remote_doubles(d->x[i], 2);
        remote_doubles(d->v[i], 2);
    }
    remote_sizes(&d->i, 1);
    remote_sizes(&d->j, 1);
    remote_sizes(&d->left, 1);
    remote_doubles(&d->impulse, 1);
}

/* What the loop has done, which is nothing where the list is not full. */
enum { NOTHING, NEXT, FLY, COLLIDE, RECORD };

enum { ROOM = 320 };

struct deeds {
    int what[ROOM];
    double time[ROOM];
};

static void move_deeds(struct deeds *d)
{
    remote_ints(d->what, ROOM);
    remote_doubles(d->time, ROOM);
}

#ifdef REMOTE_SERVER

struct box {
    struct disks disks;
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
    remote_callback(0);
    move_deeds(&box->deeds);
    remote_callback_wait();
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
    add(box, NEXT, 0.0);
    return disks_next(&box->disks);
}

void box_fly(struct box *box, double time)
{
    add(box, FLY, time);
    disks_fly(&box->disks, time);
}

void box_collide(struct box *box)
{
    add(box, COLLIDE, 0.0);
    disks_collide(&box->disks);
}

void box_record(struct box *box, double t)
{
    add(box, RECORD, t);
}

void remote_serve(void)
{
    struct box *box = remote_memory(sizeof *box);
    double tick;
    size_t samples;
    remote_doubles(&tick, 1);
    remote_sizes(&samples, 1);
    move_disks(&box->disks);
    clear(box);
    box_run(box, tick, samples);
    send(box);
    free(box);
    remote_reply();
}

#else

/* The box of the call that is under way. */
static struct box *present;

static void do_all(const struct deeds *d)
{
    for (size_t k = 0; k < ROOM; ++k)
        switch (d->what[k]) {
        case NEXT: box_next(present); break;
        case FLY: box_fly(present, d->time[k]); break;
        case COLLIDE: box_collide(present); break;
        case RECORD: box_record(present, d->time[k]); break;
        default: break;
        }
}

void remote_serve_callback(int which)
{
    struct deeds d;
    (void)which;
    move_deeds(&d);
    do_all(&d);
    remote_callback_reply();
}

void box_run(struct box *box, double tick, size_t samples)
{
    struct disks copy = *(struct disks *)box;
    present = box;
    remote_call();
    remote_doubles(&tick, 1);
    remote_sizes(&samples, 1);
    move_disks(&copy);
    remote_wait();
}

#endif
