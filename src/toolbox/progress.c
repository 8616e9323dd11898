/* Writes the progress line, and handles signals that end a run. */
#include "toolbox/progress.h"

#include "toolbox/bench.h"
#include "toolbox/replace.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

void progress_begin(struct progress *p, const char *program, uint64_t total,
                    const char *what)
{
    *p = (struct progress){.program = program, .what = what};
    p->total = total;
    p->start = bench_clock();
    p->visible = isatty(STDERR_FILENO) == 1;
}

static double fraction_done(const struct progress *p)
{
    return p->total > 0 ? (double)p->done / (double)p->total : 0;
}

/* Overwrites the previous line, with spaces after the new line if it is
   shorter. The time left is estimated as elapsed (1-f)/f, where f is the
   fraction done, as if the work were spread evenly. */
static void print_progress(struct progress *p, double elapsed,
                           uint64_t events)
{
    char line[77], left[32] = "";
    const double f = fraction_done(p);
    if (f > 0)
        snprintf(left, sizeof left, ", %.0f s left",
                 ceil(elapsed * (1 - f) / f));
    snprintf(line, sizeof line, "%s: %.0f %% done, %.2g %s/s%s", p->program,
             floor(100 * f), (double)events / elapsed, p->what, left);
    const int width = (int)strlen(line);
    const int rest = p->width > width ? p->width - width : 0;
    fprintf(stderr, "\r%s%*s", line, rest, "");
    p->width = width;
}

/* Prints nothing in the first second, because most runs end before that. */
void progress_update(struct progress *p, uint64_t done, uint64_t events)
{
    p->done = done;
    if (!p->visible)
        return;
    const double now = bench_clock();
    if (now - p->start < 1 || now - p->last < 0.2)
        return;
    p->last = now;
    print_progress(p, now - p->start, events);
}

/* Time allowed for a run to end after a signal, s. Some loops seldom check
   for signals, and a program that waits for input does not check at all. */
enum { SECONDS_TO_END = 10 };
static volatile sig_atomic_t signal_seen;

/* Stores the number of the first signal, and ends the process at the
   second. The type of signal_seen is one that a handler can write in a
   single step. */
static void note_signal(int number)
{
    if (signal_seen) {
        replace_abandon();
        signal(number, SIG_DFL);
        raise(number);
    }
    signal_seen = number;
    alarm(SECONDS_TO_END);
}

/* Handles SIGALRM, which is sent if the run has not ended in time: ends the
   process with the signal that asked it to stop. */
static void end_process(int number)
{
    (void)number;
    replace_abandon();
    signal(signal_seen, SIG_DFL);
    raise(signal_seen);
}

int progress_signal(void)
{
    return signal_seen;
}

/* Without SA_RESTART, a write that the signal interrupts would fail, and a
   run that its user stopped would report a disk error. */
void progress_catch_signals(void)
{
    const int numbers[] = {SIGINT, SIGTERM, SIGHUP, SIGXCPU};
    struct sigaction old, new = {.sa_handler = note_signal};
    new.sa_flags = SA_RESTART;
    sigemptyset(&new.sa_mask);
    for (int i = 0; i < 4; ++i)
        if (sigaction(numbers[i], NULL, &old) == 0 &&
            old.sa_handler != SIG_IGN)
            sigaction(numbers[i], &new, NULL);
    new.sa_handler = end_process;
    sigaction(SIGALRM, &new, NULL);
}

bool progress_end(struct progress *p)
{
    if (p->width > 0)
        fprintf(stderr, "\r%*s\r", p->width, "");
    p->width = 0;
    alarm(0);
    if (!signal_seen)
        return true;
    fprintf(stderr, "%s: interrupted", p->program);
    if (p->total > 0)
        fprintf(stderr, "; %.0f %% was done",
                floor(100 * fraction_done(p)));
    fputc('\n', stderr);
    return false;
}
