/* Masses, positions and velocities at the start of a run on a line. */
#ifndef START_H
#define START_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The start of a run on a line: movers from left to right between two
   walls. Each array has `movers` numbers. */
struct start {
    size_t movers;
    double *mass, *x, *v, *radius; /* kg, m, m/s, m */
    double wall[2];                /* m; -INFINITY or INFINITY: no wall */
    double until;                  /* usual duration of such a run, s */
    double gravity;                /* towards the left wall, m/s2 */
};

enum start_kind {
    START_FOUR,      /* four heavy bodies */
    START_MIXED,     /* four heavy and four light bodies */
    START_CRADLE,    /* two heavy bodies beside six light ones */
    START_THERMAL,   /* masses near 1 kg on the left, 4 kg on the right */
    START_PISTON,    /* a piston of 40 kg among ten bodies, all at 1 m/s */
    START_ADIABATIC, /* a piston between two warm gases */
    START_TWO,       /* two bodies */
    START_RANDOM,    /* masses from 1 to 9 kg, all different */
    START_GALPERIN,  /* two bodies and one wall */
    START_KINDS
};

/* The names of the kinds, in the order of enum start_kind, then NULL. */
extern const char *const start_names[START_KINDS + 1];

/* Allocates a start for this number of movers. All masses are 1 kg, and all
   other numbers 0. Returns false, with nothing to free, if memory runs
   out. */
bool start_create(struct start *s, size_t movers);
void start_free(struct start *s);

/* A request to start_fill. Members that are zero select the defaults. ratio
   is a ratio of masses: of the second body to the first (START_TWO,
   START_GALPERIN), or of the piston to the mean of the others
   (START_PISTON, START_ADIABATIC). */
struct start_request {
    enum start_kind kind;
    size_t movers;
    double ratio;
    bool walls; /* whether wall is given */
    double wall[2];
    uint64_t seed; /* seed of the random numbers */
};

/* Returns whether this kind of start allows this number of movers. 0
   selects the default number. */
bool start_allows(enum start_kind kind, size_t movers);

/* Allocates and fills in a start. Returns false, with nothing to free, if
   memory runs out. Requires that start_allows returns true. */
bool start_fill(struct start *s, const struct start_request *request);

#endif
