/* Shows the progress of a long run, and lets a signal stop it. */
#ifndef TOOLBOX_PROGRESS_H
#define TOOLBOX_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

/* The line that shows the progress of a run. The fields are private. */
struct progress {
    const char *program, *what;
    uint64_t total, done;
    double start, last; /* times of the start and the last line, s */
    int width;          /* width of the line shown; 0: none */
    bool visible;
};

/* Starts the clock. total is the final value of done, 0 if that is not
   known; what names the events, as in "collisions". Strings are not
   copied. */
void progress_begin(struct progress *p, const char *program, uint64_t total,
                    const char *what);

/* Shows the fraction done, the events per second and the time left on
   standard error, at most 5 times per second, if that is a terminal and the
   run has lasted a second. Each call reads the clock; one call in a
   thousand events is enough. */
void progress_update(struct progress *p, uint64_t done, uint64_t events);

/* Makes the first SIGINT, SIGTERM, SIGHUP or SIGXCPU only set what
   progress_signal returns: the main loop checks it now and then, ends, and
   closes its tables as usual. The second signal ends the process, and so do
   ten seconds without progress_end. A signal that the process was started
   to ignore stays ignored. */
void progress_catch_signals(void);

/* Returns the signal that asks the run to stop, or 0. */
int progress_signal(void);

/* Clears the line. Returns true if no signal has asked the run to stop;
   otherwise prints the fraction done on standard error and returns false.
   The program then exits with status 1, so that no script takes an
   incomplete run for a whole one. */
bool progress_end(struct progress *p);

#endif
