/* Times for tables of speed: clocks, medians, the name of the machine. */
/* Each time is the processor time of one process, the median of an odd
   number of runs: a mean would include every disturbance, and a minimum is
   reached only on an idle machine. Methods to be compared are run in turn,
   so that a slow minute slows all of them. */
#ifndef TOOLBOX_BENCH_H
#define TOOLBOX_BENCH_H

#include "toolbox/table.h"

#include <stddef.h>

enum {
    BENCH_ROUNDS = 5, /* runs of which the median is taken */
    BENCH_MOST = 8    /* largest number of values that take turns */
};

/* Returns the processor time that this process has used, s. */
double bench_seconds(void);

/* Returns the time of a clock that cannot be set, s. It is for work shared
   by several threads, whose processor times are added up: threads save time
   only on this clock. */
double bench_clock(void);

/* Sorts n values, n > 0, and returns their median; for even n, the larger
   of the two in the middle. */
double bench_median(double values[], size_t n);

/* Sets median[i], for i from 0 to n - 1, to the median of `value`, an
   expression in i. The values take turns, round by round, after a first
   round that warms up and is overwritten. n is BENCH_MOST at most. */
#define BENCH_TURNS(i, n, median, value)                                   \
    do {                                                                   \
        double bench_value[BENCH_MOST][BENCH_ROUNDS];                      \
        for (int bench_round = -1; bench_round < BENCH_ROUNDS;             \
             ++bench_round)                                                \
            for (int i = 0; i < (n); ++i)                                  \
                bench_value[i][bench_round < 0 ? 0 : bench_round] =        \
                    (value);                                               \
        for (int i = 0; i < (n); ++i)                                      \
            (median)[i] = bench_median(bench_value[i], BENCH_ROUNDS);      \
    } while (0)

/* Writes the processor's name, if Linux gives it, and the compiler into the
   head of a table. */
void bench_machine(struct table *t);

#endif
