/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 2388637031 of the lines below */
/* A look ahead through a whole run for the fastest that it will meet. */
#ifndef SCOUT_H
#define SCOUT_H

#include "scenes/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { SCOUT_DRAWERS = 64 };

/* What one look ahead through a whole run has met. */
struct scout {
    size_t rows, reached; /* to be looked at; so far it came */
    double *rate;         /* [rows + 1] the largest in each row, 1/s; [0] is
                             that of the start */
    double most;          /* of them */
    size_t hardest;       /* the row in which that was */
    size_t coordinates;   /* of a row's places */
    double *place;        /* [(rows + 1) * coordinates], m */
    double *nearest; /* [rows + 1] m: at which bodies passed in each row,
                        if that counts; INFINITY: none did */
    double passed[SCOUT_DRAWERS]; /* [k] the largest rate of the passages
                                     that would count if 2^k times as much
                                     did, 1/s */
    uint64_t steps;
    double cost; /* s by the price list */
};

/* How to look ahead. */
struct scout_order {
    double every; /* s, from row to row */
    size_t rows;
    double little; /* m: passages that move nobody by more do not count */
    double aim;    /* rate * step */
    double limit;  /* cost, s by the price list */
};

/* What there is to be seen at one moment. */
struct scout_sight {
    double left;   /* s, of the run */
    double little; /* m, as above */
    double around; /* s: passages so near in time, past or to come */
    const struct scene *before; /* NULL, or the state one step ago */
    double step;                /* s: so long ago */
    double *passed;  /* NULL, or [SCOUT_DRAWERS] as above, to be raised */
    double *nearest; /* NULL, or as above, to be lowered */
};

/* The rate at which forces between bodies change now, 1/s: of every pair
   that attracts, how fast it would go round, and how fast it meets, unless
   that is too weak to count. Source: (12.12, eq:scout-rate). */
double scout_rate(const struct scene *s, const struct scout_sight *sight);

/* Looks ahead through a run, with steps that follow the rate. Returns
   false, with nothing to free, when there is no memory. */
bool scout_ahead(struct scout *p, const struct scene *s,
                 const struct scout_order *o);
void scout_free(struct scout *p);

/* Do two scouts know where they have been: are they, at the beginning of
   each row, apart by less than a third of the nearest passage in it? All
   depends on rows that are short against the run: sixteen at least. */
bool scout_agree(const struct scout *a, const struct scout *b);

#endif
