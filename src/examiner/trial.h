/* Runs one test of an exercise, and judges how it ended. */
#ifndef TRIAL_H
#define TRIAL_H

#include <stdbool.h>
#include <stdio.h>

/* The state of an exercise, or of one of its tests. */
enum state {
    NOT_BEGUN,
    DOES_NOT_BUILD,
    FAILED,
    CRASHED,
    TIMED_OUT,
    PASSED
};

/* What all tests of an exercise have in common. */
struct trial {
    const char *folder; /* temporary folder, with the runner */
    const char *source; /* path of the file, as given to the compiler */
    bool sanitized;     /* compiled with the address sanitizer */
    bool leaks;         /* look for leaks as well */
    int seconds;        /* of processor time; of wall-clock time: twice */
    const char *runner; /* path of the runner from folder/desk */
    const char *seed;   /* of the inputs; NULL: that of all students */
    long user;          /* user that a judge becomes, or 0 */
    int sandbox[2];     /* pipes to a program in a sandbox, or zeros */
    int later;          /* limit after a time-out, or 0 */
    const char *prints; /* the file to which that program prints, or NULL */
};

/* Returns the name of a state: "not begun", "does not build", ... */
const char *state_name(enum state state);

/* Returns whether an exercise is begun and has not passed. */
bool state_wrong(enum state state);

/* Runs test number (from 1) and returns PASSED, FAILED, CRASHED, TIMED_OUT
   or NOT_BEGUN. Writes what there is to say about it, unless it passed,
   to story. When the examiner itself fails, says why on standard error
   and exits with status 2. */
enum state trial_run(const struct trial *trial, int number, FILE *story);

/* Starts a runner that serves all tests until trial_close, if the system
   can do that; otherwise each test starts its own. Does nothing if there
   is one. */
void trial_open(const struct trial *trial);
void trial_close(void);

/* Returns whether the last test was stopped by the limit on wall-clock
   time; it may have been late because the machine had other work. */
bool trial_waited(void);

/* Returns whether a sanitizer ended the last test because it found a
   mistake, and not because memory ran out. */
bool trial_mistake(void);

/* Returns whether the sanitizers have printed, after a test had passed,
   that memory was leaked which source had allocated; if so, writes that to
   story. */
bool trial_leak(const char *prints, const char *source, FILE *story);

#endif
