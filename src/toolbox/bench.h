/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 1132596739 of the lines below */
/* Times for tables of speed: clocks, medians, the name of the machine. */
#ifndef TOOLBOX_BENCH_H
#define TOOLBOX_BENCH_H

#include "toolbox/table.h"

#include <stddef.h>

enum { BENCH_ROUNDS = 5 }; /* runs of which the median counts */

/* Returns the processor time that this process has used, s. */
double bench_seconds(void);

/* Returns what the clock on the wall says, s since some moment. */
double bench_clock(void);

/* Sorts n values, n > 0, and returns the middle one, the upper of two. */
double bench_median(double values[], size_t n);

/* Writes the processor's name, where Linux tells it, and the compiler into
   the head of a table. */
void bench_machine(struct table *t);

#endif
