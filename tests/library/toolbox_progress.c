/* The line on the terminal, letter by letter, and what signals leave of a
   run. The clock and the terminal are the test's own, so the source of the
   module is read here, with both in place of those of the system. */
#include "unit.h"

#include "library/toolbox_child.h"
#include "toolbox/bench.h"
#include "toolbox/table.h"

#include <inttypes.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

static double now;         /* s, on the clock of the test */
static bool on_a_terminal; /* standard error is */

static double tell_time(void)
{
    return now;
}

#define bench_clock tell_time
#define isatty(file) ((file) == STDERR_FILENO && on_a_terminal)
#include <toolbox/progress.c>

static struct child told(int (*run)(void *), bool terminal)
{
    on_a_terminal = terminal;
    return child_run(run, NULL, NULL);
}

/* A run of `total` that began at t = 100, and says at a time how far it is.
 */
static void say_once(const char *program, uint64_t total, double at,
                     uint64_t done, uint64_t events)
{
    struct progress p;
    now = 100;
    progress_begin(&p, program, total, "falls");
    now = at;
    progress_update(&p, done, events);
}

static int whole_run(UNUSED void *unused)
{
    static const struct {
        double at;
        uint64_t done, events;
    } steps[] = {{100.984375, 40, 40},  /* less than a second: no line */
                 {101, 50, 40},         /* a quarter in one second */
                 {101.1875, 60, 50},    /* less than a fifth after that */
                 {101.203125, 100, 77}, /* more */
                 {110, 199, 5},         {120, 20, 20}};
    struct progress p;
    now = 100;
    progress_begin(&p, "drop", 200, "falls");
    for (size_t i = 0; i < sizeof steps / sizeof *steps; ++i) {
        now = steps[i].at;
        progress_update(&p, steps[i].done, steps[i].events);
    }
    return progress_end(&p) && progress_end(&p) ? 0 : 1;
}

/* Each line covers what is left of the longer one before it, and the last
   is wiped out, once. Without a terminal there is none. */
TEST(test_lines, "five times a second at most a line is renewed")
{
    struct child c = told(whole_run, true);
    UNIT_TRUE(c.status == 0 && *c.out == '\0');
    UNIT_SAYS(c.err, "\rdrop: 25 % done, 40 falls/s, 3 s left"
                     "\rdrop: 50 % done, 64 falls/s, 2 s left"
                     "\rdrop: 99 % done, 0.5 falls/s, 1 s left"
                     "\rdrop: 10 % done, 1 falls/s, 180 s left"
                     "\r                                      \r");
    c = told(whole_run, false);
    UNIT_TRUE(c.status == 0 && *c.err == '\0');
}

static int short_line(UNUSED void *unused)
{
    struct progress p;
    now = 100;
    progress_begin(&p, "drop", 4, "falls");
    now = 200;
    progress_update(&p, 1, 120);
    now = 201;
    progress_update(&p, 0, 202);
    now = 202;
    p.total = 0; /* it is not known how much there is to do */
    progress_update(&p, 2, 408);
    p.total = 1;
    now = 203;
    progress_update(&p, 1, 515);
    return 0;
}

TEST(test_short_line, "what is not known is not said")
{
    const struct child c = told(short_line, true);
    UNIT_SAYS(c.err, "\rdrop: 25 % done, 1.2 falls/s, 300 s left"
                     "\rdrop: 0 % done, 2 falls/s               "
                     "\rdrop: 0 % done, 4 falls/s"
                     "\rdrop: 100 % done, 5 falls/s, 0 s left");
}

static int long_lines(UNUSED void *unused)
{
    say_once("a-program-whose-name-alone-is-so-long-that-the-line-does-not-"
             "fit-into-eighty-columns",
             2, 101, 1, 1);
    say_once("drop", UINT64_MAX, 200, 1, 1);
    say_once("drop", UINT64_MAX, 1100, 1, 1);
    return 0;
}

/* A line is cut before a terminal of 80 columns would go on in the next,
   and so is a time of thousands of ages of the universe. */
TEST(test_long_lines, "a line ends before the terminal does")
{
    const struct child c = told(long_lines, true);
    UNIT_SAYS(c.err,
              "\ra-program-whose-name-alone-is-so-long-that-the-line-does-"
              "not-fit-into-eighty"
              "\rdrop: 0 % done, 0.01 falls/s, 1844674407370955161600 s "
              "left"
              "\rdrop: 0 % done, 0.001 falls/s, 18446744073709551616000 s "
              "lef");
}

static int signal_number;

/* What the signal interrupts goes on, knows of it, and has ten seconds. */
static int caught(void *total)
{
    struct progress p;
    progress_begin(&p, "drop", total ? 200 : 0, "falls");
    progress_catch_signals();
    if (progress_signal() != 0)
        return 3;
    raise(signal_number);
    if (progress_signal() != signal_number || alarm(10) != 10)
        return 4;
    progress_update(&p, 111, 5);
    return progress_end(&p) ? 5 : alarm(0) == 0 ? 0 : 6;
}

TEST(test_caught, "a signal is noted, with how far the run was")
{
    const int numbers[] = {SIGINT, SIGTERM, SIGHUP, SIGXCPU};
    for (size_t i = 0; i < 4; ++i) {
        signal_number = numbers[i];
        struct child c = told(caught, false);
        UNIT_EQUAL(c.status, 0);
        UNIT_SAYS(c.err, "drop: interrupted\n");
        c = child_run(caught, "known", NULL);
        UNIT_SAYS(c.err, "drop: interrupted; 55 % was done\n");
    }
}

static int ignored(UNUSED void *unused)
{
    signal(signal_number, SIG_IGN);
    progress_catch_signals();
    raise(signal_number);
    return progress_signal();
}

/* (nohup has a run ignore the terminal's end.) */
TEST(test_ignored, "a signal ignored stays ignored")
{
    const int numbers[] = {SIGINT, SIGTERM, SIGHUP, SIGXCPU};
    for (size_t i = 0; i < 4; ++i) {
        signal_number = numbers[i];
        UNIT_EQUAL(told(ignored, false).status, 0);
    }
}

static char folder[] = "build/tests/progress-XXXXXX";
static int second;

/* The second signal, or the alarm, ends it at once, and its file is gone.
 */
static int ended(UNUSED void *unused)
{
    static struct table
        *volatile t; /* so that it does not count as leaked */
    char path[64];
    snprintf(path, sizeof path, "%s/table", folder);
    t = table_open("drop", path);
    progress_catch_signals();
    if (!t || raise(signal_number) != 0)
        return 3;
    raise(second);
    return 4;
}

TEST(test_ended, "a second signal ends it, or ten seconds")
{
    const int numbers[] = {SIGINT, SIGTERM, SIGHUP, SIGXCPU};
    for (size_t i = 0; i < 8; ++i) {
        signal_number = numbers[i % 4];
        second = i < 4 ? signal_number : SIGALRM;
        UNIT_TRUE(mkdtemp(folder) != NULL);
        UNIT_EQUAL(told(ended, false).status, 128 + signal_number);
        UNIT_TRUE(rmdir(folder) == 0); /* it is empty */
        memcpy(strchr(folder, '-') + 1, "XXXXXX", 6);
    }
}

/* A signal while it reads does not end the reading. */
static int reading(UNUSED void *unused)
{
    const struct timespec moment = {.tv_nsec = 10000000};
    const pid_t reader = getpid();
    int ends[2];
    char letter = 'a';
    progress_catch_signals();
    if (pipe(ends) != 0)
        return 3;
    if (fork() == 0) {
        nanosleep(&moment, NULL);
        kill(reader, SIGTERM);
        nanosleep(&moment, NULL);
        _exit(write(ends[1], "b", 1) != 1);
    }
    const bool whole = read(ends[0], &letter, 1) == 1 && letter == 'b';
    return whole && progress_signal() == SIGTERM ? 0 : 4;
}

TEST(test_reading, "a signal does not end the reading of a file")
{
    UNIT_EQUAL(told(reading, false).status, 0);
}
