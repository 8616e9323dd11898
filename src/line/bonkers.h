/* Bodies on a line between two walls, from one collision to the next. */
#ifndef BONKERS_H
#define BONKERS_H

#include "line/schedule.h"
#include "line/start.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A body on the line: at x + v (t - since) at the time t, until its next
   collision (2.1, eq:flight). x has the radii taken out (2.2, eq:rods). */
struct bonkers_body {
    double x;     /* m */
    double v;     /* m/s */
    double since; /* s */
    double im;    /* inverse mass, 1/kg; 0 is a wall */
};

enum bonkers_stop {
    BONKERS_TIME,       /* the time was reached */
    BONKERS_COLLISIONS, /* the number of collisions was reached */
    BONKERS_STILL,      /* no collision will come any more */
    BONKERS_COLLAPSE    /* the clock stands still: inelastic collapse */
};

/* Ways to find what happens next. All but the naive one give the same
   bits. AUTO takes the scan up to BONKERS_SCANNED movers, and the slab for
   more. */
enum bonkers_engine {
    BONKERS_AUTO,
    BONKERS_NAIVE, /* look at every gap, move everybody */
    BONKERS_SCAN,  /* look at every remembered time, move two */
    BONKERS_HEAP,  /* keep the earliest on top, move two */
    BONKERS_SLAB,  /* run far bodies independently for a short time */
    BONKERS_ENGINES
};

enum {
    BONKERS_SCANNED = 32,  /* most movers for which AUTO scans: measured */
    BONKERS_REPEATS = 100, /* of one gap at one time, and more: collapse */
    BONKERS_MOVERS = 10000000 /* most: they fit into a gigabyte */
};

/* Bodies between two walls. To be read: body, gaps, now, collisions,
   disorder, redone; to be set before the start, if not zero: gravity.
   Bodies are 0 (left wall) to gaps (right wall). */
struct bonkers {
    struct bonkers_body *body;
    size_t gaps;   /* one more than there are movers */
    double now;    /* s */
    double begun;  /* the time at which the last call began, s */
    double extent; /* the largest distance from 0 at the start, m */
    uint64_t collisions;
    uint64_t disorder; /* pairs that bonkers_state found out of order */
    uint64_t redone;   /* collisions that the slab engine did twice */
    enum bonkers_engine engine;
    double restitution;
    double gravity;    /* towards body 0, m/s2; not negative */
    double *due;       /* when gap i will close, s */
    double *shift;     /* the s_i of (2.2, eq:rods); NULL: all zero */
    uint32_t *repeats; /* collisions of gap i at one time; NULL: elastic */
    double *fraction;  /* f of gap i (1.12, eq:smaller); NULL: not kept */
    struct schedule schedule;
    struct bonkers_slab *slab;
};

/* Prepares movers bodies between two walls, all at zero, with restitution
   from 0 to 1, for an engine. Requires 1 to BONKERS_MOVERS movers. Returns
   false, with nothing to free, when there is no memory. */
bool bonkers_create(struct bonkers *b, size_t movers, double restitution,
                    enum bonkers_engine engine);
void bonkers_free(struct bonkers *b);

/* Starts the clock at 0 with body[0..gaps] as the caller has filled it in:
   x (m, the centre), v (m/s) and im (1/kg); radius: of bodies 0 to gaps
   (m), or NULL for points. An x of -INFINITY or INFINITY is no wall at all
   on that side. Returns the number of gaps if all is well; otherwise
   the first gap that is narrower than the two radii, or NaN. */
size_t bonkers_start(struct bonkers *b, const double radius[]);

/* Runs until the time `until` (s, INFINITY allowed), the collision number
   `collisions` or the last collision, whichever comes first, and says
   which. A collision exactly at `until` takes place. Calls may follow each
   other; the number of calls does not affect the results, except in the
   naive engine. Under gravity what is at rest on the floor, or on others
   that are, stays; with restitution below 1 a body comes to rest there when
   a bounce is too short for the clock. */
enum bonkers_stop bonkers_run(struct bonkers *b, double until,
                              uint64_t collisions);

/* Fills x (m) and v (m/s) with the state of bodies 0 to gaps at b->now,
   changing nothing but b->disorder. The positions are in order. */
void bonkers_state(struct bonkers *b, double x[], double v[]);

/* Says whether no collision will come any more. */
bool bonkers_is_still(const struct bonkers *b);

/* Below this speed, m/s, the squares of speeds leave the range of numbers:
   a square of 2^-900 has 70 bits above the last number of full precision,
   2^-970 before rounding, so that energies are sums of full numbers down to
   speeds 3e10 times slower. A run with restitution below 1 that collides
   slower than that, at a clock that moves, ends as BONKERS_COLLAPSE: all
   that is faster has met its last partner before. */
#define BONKERS_SLOWEST 0x1p-450

/* Returns whether a run that has ended as BONKERS_COLLAPSE was too cold to
   go on, and no clock stood still. */
bool bonkers_is_cold(const struct bonkers *b);

/* Returns the energy of the movers, J, summed from the left: kinetic and,
   under gravity, potential, which is 0 when all of them lie on the floor.
 */
double bonkers_energy(const struct bonkers *b);

/* The engines' names, in the order of enum bonkers_engine, then NULL. */
extern const char *const bonkers_engine_names[BONKERS_ENGINES + 1];

/* Makes and starts a run of s, as bonkers_create and bonkers_start do, and
   sets *wrong to what bonkers_start has returned. */
bool bonkers_begin(struct bonkers *b, const struct start *s,
                   double restitution, enum bonkers_engine engine,
                   size_t *wrong);

/* Moves every body to where it is at b->now, and sets the clock to 0, with
   no collisions counted. To go on call bonkers_start with the radii. */
void bonkers_settle(struct bonkers *b);

#endif
