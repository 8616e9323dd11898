/* From chapters/works/12-models.nw: edit there, then run make tangle. */
/* checksum 1897913714 of the lines below */
/* What a unit of work costs on this machine. */
#ifndef PRICES_H
#define PRICES_H

#include "enough/models.h"

/* Measures what a unit costs on this machine, ns of processor time: the
   median of BENCH_ROUNDS runs with many such units, less what the list
   says of the others. NaN without memory. */
double prices_measure(enum models_unit unit);

#endif
