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

/* Starts the clock. total is the final value of `done', or 0 if the final
   value is unknown. `what' names the events, such as "collisions". The
   strings are not copied. */
void progress_begin(struct progress *p, const char *program, uint64_t total,
                    const char *what);

/* Shows the fraction done, the events per second and the time left on
   standard error, if that is a terminal. Begins after one second and writes
   at most 5 lines per second. Each call reads the clock, so one call per
   thousand events is enough. */
void progress_update(struct progress *p, uint64_t done, uint64_t events);

/* Makes the first SIGINT, SIGTERM, SIGHUP or SIGXCPU only set the value
   that progress_signal returns. The main loop should check this value now
   and then, and if it is set, end and close its tables as usual. A second
   signal ends the process at once. The process also ends if progress_end is
   not called within ten seconds of the first signal. A signal that was
   ignored when the process started stays ignored. */
void progress_catch_signals(void);

/* Returns the signal that has asked the run to stop, or 0. */
int progress_signal(void);

/* Clears the line. Returns true if no signal has asked the run to stop.
   Otherwise prints the fraction done on standard error and returns false.
   The program must then exit with status 1, to tell scripts that the run is
   incomplete. */
bool progress_end(struct progress *p);

#endif
