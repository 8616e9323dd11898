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

/* The settings common to all tests of an exercise. */
struct trial {
    const char *folder; /* temporary folder, with the runner */
    const char *source; /* path of the file, as given to the compiler */
    bool sanitized;     /* compiled with the address sanitizer */
    bool leaks;         /* search for leaks as well */
    int seconds;        /* limit on processor time, s; wall clock: twice */
    const char *runner; /* path of the runner, relative to folder/desk */
    const char *seed;   /* seed of the inputs; NULL: the usual seed */
    long user;          /* user ID for the judge, or 0 */
    int sandbox[2];     /* pipes to a program in a sandbox, or zeros */
    int later;          /* time limit after a time-out, s; 0: unchanged */
    const char *prints; /* output of a program in a sandbox, or NULL */
};

/* Returns the name of a state: "not begun", "does not build", ... */
const char *state_name(enum state state);

/* Returns whether a state is neither "not begun" nor "passed". */
bool state_wrong(enum state state);

/* Runs test `number`, from 1, and returns PASSED, FAILED, CRASHED,
   TIMED_OUT or NOT_BEGUN. Unless the test passed, writes a report on it to
   `story`. If the examiner itself fails, prints why on standard error and
   exits with status 2. */
enum state trial_run(const struct trial *trial, int number, FILE *story);

/* Starts a runner that serves all tests until trial_close, if the system
   can do that. Otherwise each test starts its own runner. Does nothing if a
   runner was started before. */
void trial_open(const struct trial *trial);
void trial_close(void);

/* Returns whether the last test was stopped by the limit on wall-clock
   time, perhaps because the machine was busy. */
bool trial_waited(void);

/* Returns whether a sanitizer ended the last test because it found a
   mistake, and not because memory ran out. */
bool trial_mistake(void);

/* Returns whether `prints`, the output of a test that passed, reports a
   leak of memory that `source` had allocated. If so, explains it in
   `story`. */
bool trial_leak(const char *prints, const char *source, FILE *story);

#endif
