/* Masses, positions and velocities with which a run on a line begins. */
#ifndef START_H
#define START_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What a run on a line starts from: movers from left to right between two
   walls. Each array has `movers` numbers. */
struct start {
    size_t movers;
    double *mass, *x, *v, *radius; /* kg, m, m/s, m */
    double wall[2]; /* m; -INFINITY or INFINITY: none on that side */
    double until;   /* how long such a run usually takes, s */
    double gravity; /* towards the left wall, m/s2 */
};

enum start_kind {
    START_FOUR,      /* masses 11 to 41, with radii */
    START_MIXED,     /* four heavy and four light */
    START_CRADLE,    /* two heavy ones beside six light ones */
    START_THERMAL,   /* the left half of mass near 1, the right near 4 */
    START_PISTON,    /* one of 40 kg among ten of 4/3, all at 1 m/s */
    START_ADIABATIC, /* the same piston between two warm gases */
    START_TWO,       /* two bodies */
    START_RANDOM,    /* masses from 1 to 9, all different */
    START_GALPERIN,  /* two bodies and one wall */
    START_KINDS
};

/* The names, in the order of enum start_kind, then NULL. */
extern const char *const start_names[START_KINDS + 1];

/* Makes room for this many movers: masses 1, all else 0. Returns false,
   with nothing to free, when there is no memory. */
bool start_create(struct start *s, size_t movers);
void start_free(struct start *s);

/* What start_fill can be asked for. Zero is the usual value. */
struct start_request {
    enum start_kind kind;
    size_t movers;
    double ratio; /* of masses; two, galperin: of the second to the
                     first; piston, adiabatic: of the piston to the mean
                     of the others; for no other kind */
    bool walls;   /* wall is given */
    double wall[2];
    uint64_t seed; /* of what is drawn at random */
};

/* Says whether this kind of start can have so many movers, or 0. */
bool start_allows(enum start_kind kind, size_t movers);

/* Makes and fills in a start. Requires that start_allows the number.
   Returns false, with nothing to free, when there is no memory. */
bool start_fill(struct start *s, const struct start_request *request);

#endif
