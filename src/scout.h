/* From chapters/12-choose.nw: edit there, then run make tangle. */
/* checksum 2116679731 of the lines below */
#ifndef SCOUT_H
#define SCOUT_H

#include "scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What one look ahead through a whole run has met. */
struct scout {
    size_t rows, reached; /* to be looked at; so far it came */
    double *rate;         /* [rows + 1] the largest in each row, 1/s; [0] is
                             that of the start */
    double most;          /* of them */
    size_t hardest;       /* the row in which that was */
    uint64_t steps;
    double cost; /* s by the price list */
};

/* The rate at which forces between bodies change now, 1/s: of every pair
   that attracts, how fast it would go round, and how fast it meets; pairs
   that could not move each other by more than `little`, m, in the time
   left, s, do not count. */
double scout_rate(const struct scene *s, double left, double little);

/* Looks ahead: so many rows, `every` seconds each, with steps that follow
   the rate, at a cost below limit. Returns false, with nothing to free,
   when there is no memory. */
bool scout_ahead(struct scout *p, const struct scene *s, double every,
                 size_t rows, double little, double limit);
void scout_free(struct scout *p);

#endif
