/* Times for tables of speed: clocks, medians, the name of the machine. */
/* A time is processor time of one process and the median of an odd number
   of runs: the mean counts every disturbance in full, and the minimum is
   what a machine does that nobody else uses. Ways to be compared take
   turns, so that a slow minute slows all of them. */
#ifndef TOOLBOX_BENCH_H
#define TOOLBOX_BENCH_H

#include "toolbox/table.h"

#include <stddef.h>

enum { BENCH_ROUNDS = 5 }; /* runs to take a median of */

/* Returns the processor time that this process has used, s. */
double bench_seconds(void);

/* Returns the time of a clock that never jumps, s since some moment. For
   work that several threads share, where processor time counts all of
   them, and what they save is time on this clock. */
double bench_clock(void);

/* Sorts n values, n > 0, and returns the middle one, the upper of two. */
double bench_median(double values[], size_t n);

/* Writes the processor's name, where Linux tells it, and the compiler into
   the head of a table. */
void bench_machine(struct table *t);

#endif
