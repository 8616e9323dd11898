/* The toolbox's timing: the median, processor time, and what is said of the
   machine. */
#include "toolbox/bench.h"
#include "unit.h"

#include <time.h>

TEST(test_median, "the median is the middle one, the upper of two")
{
    double odd[] = {3, 1, 2, 9, -5}, even[] = {4, 1, 3, 2}, one[] = {7};
    UNIT_EQUAL(bench_median(odd, 5), 2);
    UNIT_EQUAL(bench_median(even, 4), 3);
    UNIT_EQUAL(bench_median(one, 1), 7);
}

TEST(test_sorted, "the values are sorted, the least first")
{
    double values[] = {3, 1, 2, 9, -5};
    bench_median(values, 5);
    for (int i = 1; i < 5; ++i)
        UNIT_TRUE(values[i - 1] < values[i]);
}

/* The calls are numbered from 0. With two values the first round has the
   calls 0 and 1, which do not count; the median of 2, 4, ..., 10 is 6. */
TEST(test_turns, "values take turns, and their first round is discarded")
{
    int calls = 0;
    double median[] = {-1, -1, -1};
    BENCH_TURNS(i, 2, median, calls++ + 100 * i);
    UNIT_EQUAL(calls, 2 * (BENCH_ROUNDS + 1));
    UNIT_EQUAL(median[0], 6);
    UNIT_EQUAL(median[1], 107);
    UNIT_EQUAL(median[2], -1);
}

/* clock() has steps of a microsecond; the loop ends by the clock itself. */
TEST(test_seconds, "the processor's clock runs")
{
    const double start = bench_seconds();
    double now = start;
    for (long k = 0; k < 2000000000L && now < start + 0.01; ++k)
        now = bench_seconds();
    UNIT_TRUE(start >= 0 && start < 1000); /* s, not ticks */
    UNIT_TRUE(now >= start + 0.01);
}

static double seconds_of(const struct timespec *t)
{
    return (double)t->tv_sec + (double)t->tv_nsec / 1e9;
}

TEST(test_clock, "so does that on the wall")
{
    struct timespec before, after;
    for (int k = 0; k < 10; ++k) {
        clock_gettime(CLOCK_MONOTONIC, &before);
        const double now = bench_clock();
        clock_gettime(CLOCK_MONOTONIC, &after);
        UNIT_TRUE(now >= seconds_of(&before) - 1e-6);
        UNIT_TRUE(now <= seconds_of(&after) + 1e-6);
    }
}

/* The line that says which processor it is, or "" where Linux has none. */
static void read_model(char line[BUFSIZ + 16])
{
    char given[BUFSIZ];
    FILE *file = fopen("/proc/cpuinfo", "r");
    line[0] = '\0';
    while (file && !*line && fgets(given, sizeof given, file))
        if (strncmp(given, "model name\t: ", 13) == 0)
            snprintf(line, BUFSIZ + 16, "# machine: %s", given + 13);
    if (file)
        fclose(file);
}

TEST(test_machine, "a table says what it was compiled with")
{
    char model[BUFSIZ + 16];
    char text[2048] = "";
    const char *path = "build/tests/bench.dat";
    struct table *t = table_open("test", path);
    UNIT_TRUE(t != NULL);
    if (!t)
        return;
    bench_machine(t);
    UNIT_TRUE(table_close(t));
    FILE *file = fopen(path, "r");
    UNIT_TRUE(file != NULL);
    if (!file)
        return;
    UNIT_TRUE(fread(text, 1, sizeof text - 1, file) > 0);
    fclose(file);
    remove(path);
    read_model(model);
    UNIT_TRUE(strncmp(text, model, strlen(model)) == 0);
    UNIT_TRUE(strncmp(text + strlen(model), "# compiler: ", 12) == 0);
    UNIT_TRUE(strstr(text, __VERSION__) != NULL);
}
