/* Simulates bodies on a line between two walls, collision by collision. */
#ifndef BONKERS_H
#define BONKERS_H

#include "line/schedule.h"
#include "line/start.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A body on the line. Until its next collision its position at the time t
   is x + v (t - since) (2.1, eq:flight). The radii have been subtracted
   from x (2.2, eq:rods). */
struct bonkers_body {
    double x;     /* m */
    double v;     /* m/s */
    double since; /* time of x and v, s */
    double im;    /* inverse mass, 1/kg; 0: a wall */
};

enum bonkers_stop {
    BONKERS_TIME,       /* the time was reached */
    BONKERS_COLLISIONS, /* the number of collisions was reached */
    BONKERS_STILL,      /* there will be no further collision */
    BONKERS_COLLAPSE    /* the clock does not advance, or bodies are too
                           slow */
};

/* Methods of finding the next collision. All but BONKERS_NAIVE give the
   same results to the last bit. BONKERS_AUTO selects the scan for up to
   BONKERS_SCANNED movers, and the slab engine for more. */
enum bonkers_engine {
    BONKERS_AUTO,
    BONKERS_NAIVE, /* computes all gaps, moves all bodies */
    BONKERS_SCAN,  /* compares all stored times, moves two bodies */
    BONKERS_HEAP,  /* takes the earliest time from a heap, moves two
                      bodies */
    BONKERS_SLAB,  /* runs distant bodies independently for a while */
    BONKERS_ENGINES
};

enum {
    BONKERS_SCANNED = 32,  /* largest number of movers for which the scan is
                              fastest */
    BONKERS_REPEATS = 100, /* see most_repeats */
    BONKERS_MOVERS = 10000000 /* largest number of movers (1 GB) */
};

/* A run of bodies between two walls. Body 0 is the left wall, and body
   `gaps` the right wall. The caller may read body, gaps, now, collisions,
   disorder and redone, and may set gravity before calling bonkers_start. */
struct bonkers {
    struct bonkers_body *body;
    size_t gaps;   /* number of movers + 1 */
    double now;    /* the present time, s */
    double begun;  /* time at the last call of bonkers_run, s */
    double extent; /* largest |x| at the start, m */
    uint64_t collisions;
    uint64_t disorder; /* pairs that bonkers_state found out of order */
    uint64_t redone;   /* collisions that the slab engine repeated */
    enum bonkers_engine engine;
    double restitution;
    double gravity;    /* acceleration towards body 0, m/s2; not negative */
    double *due;       /* time when gap i will close, s */
    double *shift;     /* the s_i of (2.2, eq:rods); NULL: all zero */
    uint32_t *repeats; /* collisions of gap i since the clock last advanced;
                          NULL: elastic */
    double *fraction;  /* f of gap i (1.12, eq:smaller), or NULL */
    struct schedule schedule;
    struct bonkers_slab *slab;
};

/* Prepares a run of `movers` bodies (1 to BONKERS_MOVERS) between two walls
   with the given engine. restitution must be from 0 to 1. All positions,
   velocities and inverse masses are set to 0. Returns false, with nothing
   to free, if memory runs out. */
bool bonkers_create(struct bonkers *b, size_t movers, double restitution,
                    enum bonkers_engine engine);
void bonkers_free(struct bonkers *b);

/* Starts a run at time 0. The caller has filled in body[0..gaps]: x (m, of
   the centre), v (m/s) and im (1/kg). radius contains the radii of bodies 0
   to gaps (m), or is NULL for points. A missing left wall has x =
   -INFINITY, and a missing right wall x = INFINITY. Returns the number of
   gaps on success. Otherwise returns the index of the first gap that is
   NaN, or whose bodies overlap. */
size_t bonkers_start(struct bonkers *b, const double radius[]);

/* Runs until the time `until` (s, may be INFINITY), until b->collisions
   reaches `collisions`, or until the last collision, whichever is first.
   Returns why the run stopped. A collision at exactly `until` takes place.
   Splitting a run into several calls does not change the results, except in
   the naive engine. Under gravity a body at rest on the floor, or on a pile
   of such bodies, stays there until it is hit. With restitution below 1 a
   body comes to rest when its bounces become shorter than the clock can
   resolve. */
enum bonkers_stop bonkers_run(struct bonkers *b, double until,
                              uint64_t collisions);

/* Fills x (m) and v (m/s) with the state of bodies 0 to gaps at b->now. The
   positions are in increasing order. Changes only b->disorder. */
void bonkers_state(struct bonkers *b, double x[], double v[]);

/* Returns whether there will be no further collision. */
bool bonkers_is_still(const struct bonkers *b);

/* Lowest relative speed of a collision, m/s. A run with restitution below 1
   ends as BONKERS_COLLAPSE if two bodies collide more slowly while the
   clock advances. All faster bodies have then had their last collision. The
   square of this speed is 2^-900. Even squares as small as 2^-970 still
   have full precision, so energies lose no digits. */
#define BONKERS_SLOWEST 0x1p-450

/* Returns whether a run ended as BONKERS_COLLAPSE because its bodies were
   too slow, and not because its clock did not advance. */
bool bonkers_is_cold(const struct bonkers *b);

/* Returns the energy of the movers, J: kinetic energy and, under gravity,
   potential energy, which is 0 if all movers lie on the floor. */
double bonkers_energy(const struct bonkers *b);

/* The engines' names, in the order of enum bonkers_engine, then NULL. */
extern const char *const bonkers_engine_names[BONKERS_ENGINES + 1];

/* Prepares and starts a run from s, as bonkers_create and bonkers_start do,
   and sets *wrong to the result of bonkers_start. Returns false, with
   nothing to free, if memory runs out. */
bool bonkers_begin(struct bonkers *b, const struct start *s,
                   double restitution, enum bonkers_engine engine,
                   size_t *wrong);

/* Moves every body to its position at b->now. Sets the clock and the number
   of collisions to 0. To continue, call bonkers_start with the radii. */
void bonkers_settle(struct bonkers *b);

#endif
