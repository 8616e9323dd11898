/* Measures computing times: clocks, medians, the name of the machine. */
/* A measured time is the median of the processor times of an odd number of
   runs. A mean would include every disturbance, and a minimum is reached
   only on an idle machine. Methods to be compared take turns, so a slow
   minute slows all of them. */
#ifndef TOOLBOX_BENCH_H
#define TOOLBOX_BENCH_H

#include "toolbox/table.h"

#include <stddef.h>

enum {
    BENCH_ROUNDS = 5, /* number of runs for a median */
    BENCH_MOST = 8    /* largest n of BENCH_TURNS */
};

/* Returns the processor time that this process has used [s]. */
double bench_seconds(void);

/* Returns the time [s] on a clock that cannot be set. Use this clock for
   work that several threads share: processor time is the sum over all
   threads and does not show the time that threads save. */
double bench_clock(void);

/* Sorts the values and returns their median. For even n, returns the larger
   of the two values in the middle. Requires n > 0. */
double bench_median(double values[], size_t n);

/* Measures the expression `value', which may contain i, for each i from 0
   to n - 1, and sets median[i] to the median of its values. Each round
   evaluates the expression once for every i. A first round warms up and
   does not count. Requires n <= BENCH_MOST. */
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

/* Writes the compiler, its flags and, on Linux, the name of the processor
   to the head of a table. */
void bench_machine(struct table *t);

#endif
