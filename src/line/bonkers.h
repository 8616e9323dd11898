/* Bodies on a line between two walls, from one collision to the next. */
#ifndef BONKERS_H
#define BONKERS_H

#include "line/schedule.h"
#include "line/start.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A body on the line: at x + v (t - since) at the time t, until its next
   collision (2.1, eq:flight). The radii are subtracted from x (2.2,
   eq:rods). */
struct bonkers_body {
    double x;     /* m */
    double v;     /* m/s */
    double since; /* s */
    double im;    /* inverse mass, 1/kg; 0: a wall */
};

enum bonkers_stop {
    BONKERS_TIME,       /* the time was reached */
    BONKERS_COLLISIONS, /* the number of collisions was reached */
    BONKERS_STILL,      /* no collision will follow */
    BONKERS_COLLAPSE    /* the clock no longer advances, or too cold */
};

/* Methods of finding the next collision; all but the naive one agree to the
   last bit. AUTO is SCAN up to BONKERS_SCANNED movers, and SLAB for
   more. */
enum bonkers_engine {
    BONKERS_AUTO,
    BONKERS_NAIVE, /* compute all gaps, move all bodies */
    BONKERS_SCAN,  /* compare all stored times, move two bodies */
    BONKERS_HEAP,  /* earliest time on top, move two bodies */
    BONKERS_SLAB,  /* run distant bodies independently for a while */
    BONKERS_ENGINES
};

enum {
    BONKERS_SCANNED = 32,  /* most movers for which the scan is fastest */
    BONKERS_REPEATS = 100, /* of one gap at one time: a collapse */
    BONKERS_MOVERS = 10000000 /* largest number: they fill a gigabyte */
};

/* Bodies between two walls: 0 (left wall) to gaps (right wall). May be
   read: body, gaps, now, collisions, disorder, redone; may be set before
   the start: gravity. */
struct bonkers {
    struct bonkers_body *body;
    size_t gaps;   /* number of movers + 1 */
    double now;    /* the present time, s */
    double begun;  /* when the present call of bonkers_run began, s */
    double extent; /* largest distance from 0 at the start, m */
    uint64_t collisions;
    uint64_t disorder; /* pairs that bonkers_state found out of order */
    uint64_t redone;   /* collisions that the slab engine repeated */
    enum bonkers_engine engine;
    double restitution;
    double gravity;    /* towards body 0, m/s2; not negative */
    double *due;       /* when gap i will close, s */
    double *shift;     /* the s_i of (2.2, eq:rods); NULL: all zero */
    uint32_t *repeats; /* collisions of gap i at one time; NULL: elastic */
    double *fraction;  /* f of gap i (1.12, eq:smaller), or NULL */
    struct schedule schedule;
    struct bonkers_slab *slab;
};

/* Prepares movers bodies between two walls, all numbers zero, with
   restitution from 0 to 1, for an engine. Requires 1 to BONKERS_MOVERS
   movers. Returns false, with nothing to free, if memory runs out. */
bool bonkers_create(struct bonkers *b, size_t movers, double restitution,
                    enum bonkers_engine engine);
void bonkers_free(struct bonkers *b);

/* Starts the clock at 0 with body[0..gaps] as filled in by the caller: x
   (m, of the centre), v (m/s) and im (1/kg); radius: of bodies 0 to gaps
   (m), or NULL for points. An x of -INFINITY or INFINITY means no wall on
   that side. Returns the number of gaps on success; otherwise the first gap
   that is narrower than the two radii, or NaN. */
size_t bonkers_start(struct bonkers *b, const double radius[]);

/* Runs until the time `until` (s, may be INFINITY), the collision number
   `collisions` or the last collision, whichever comes first, and returns
   which. A collision exactly at `until` takes place. The number of calls
   does not affect the results, except in the naive engine. Under gravity a
   body at rest on the floor, or on others that are, stays there; with
   restitution below 1 bodies come to rest when bounces are too short for
   the clock. */
enum bonkers_stop bonkers_run(struct bonkers *b, double until,
                              uint64_t collisions);

/* Fills x (m) and v (m/s) with the state of bodies 0 to gaps at b->now, the
   positions in increasing order. Changes nothing but b->disorder. */
void bonkers_state(struct bonkers *b, double x[], double v[]);

/* Says whether there will be no further collision. */
bool bonkers_is_still(const struct bonkers *b);

/* The speed, m/s, below which squares of speeds lose precision: a square of
   2^-900 is 70 bits above 2^-970, the last number of full precision, so
   that energies are sums of full-precision numbers down to speeds 3e10
   times slower. A run with restitution below 1 ends as BONKERS_COLLAPSE at
   a collision with a slower approach while the clock advances: all faster
   bodies have then had their last collision. */
#define BONKERS_SLOWEST 0x1p-450

/* Returns whether a run that ended as BONKERS_COLLAPSE was too cold to go
   on, while its clock still advanced. */
bool bonkers_is_cold(const struct bonkers *b);

/* Returns the energy of the movers, J, summed from the left: kinetic and,
   under gravity, potential, which is 0 with all of them on the floor. */
double bonkers_energy(const struct bonkers *b);

/* The engines' names, in the order of enum bonkers_engine, then NULL. */
extern const char *const bonkers_engine_names[BONKERS_ENGINES + 1];

/* Makes and starts a run from s, as bonkers_create and bonkers_start do;
   sets *wrong to what bonkers_start returned. Returns false if memory runs
   out or the start fails. */
bool bonkers_begin(struct bonkers *b, const struct start *s,
                   double restitution, enum bonkers_engine engine,
                   size_t *wrong);

/* Moves every body to its place at b->now, sets the clock and the number of
   collisions to 0. To continue, call bonkers_start with the radii. */
void bonkers_settle(struct bonkers *b);

#endif
