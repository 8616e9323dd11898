/* Reads processor time and clocks, finds medians, names the machine. */
#include "toolbox/bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifndef BUILD_FLAGS
#define BUILD_FLAGS "unknown flags"
#endif
#ifdef __clang__
#define COMPILER "" /* clang's version string begins with its name */
#else
#define COMPILER "gcc "
#endif

double bench_seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

double bench_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double bench_median(double values[], size_t n)
{
    qsort(values, n, sizeof values[0], by_size);
    return values[n / 2];
}

void bench_machine(struct table *t)
{
    char line[BUFSIZ];
    FILE *file = fopen("/proc/cpuinfo", "r");
    while (file && fgets(line, sizeof line, file))
        if (strncmp(line, "model name", 10) == 0) {
            table_print(t, "# machine: %s", strchr(line, ':') + 2);
            break;
        }
    if (file)
        fclose(file);
    table_print(t, "# compiler: %s%s, %s\n", COMPILER, __VERSION__,
                BUILD_FLAGS);
}
