/* Runs one test of an exercise and judges it: six states. */
#ifndef TRIAL_H
#define TRIAL_H

#include <stdbool.h>
#include <stdio.h>

/* How an exercise, or one of its tests, stands. */
enum state {
    NOT_BEGUN,
    DOES_NOT_BUILD,
    FAILED,
    CRASHED,
    TIMED_OUT,
    PASSED
};

/* What stays the same for the tests of an exercise. */
struct trial {
    const char *folder; /* of our own, with the runner in it */
    const char *source; /* the student's file, as the compiler saw it */
    bool sanitized;     /* compiled with the address sanitizer */
    bool leaks;         /* which is to look for lost memory, too */
    int seconds;        /* of processor time; twice that on the wall */
    const char *runner; /* to be started, as seen from folder/desk */
    const char *seed;   /* of the inputs, in digits; NULL: the students' */
    long user;          /* which a judge that root starts becomes, or 0 */
    int sandbox[2];     /* the way to a program in a box, or zeros */
    int later;          /* seconds for a test after one was late, or 0 */
    const char *prints; /* what such a program prints to, or NULL */
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

/* Starts the runner once for all tests that follow, where that can be done,
   until trial_close; nothing happens if there is one. Without it each test
   starts its own. */
void trial_open(const struct trial *trial);
void trial_close(void);

/* Whether the last test was stopped by the clock on the wall, and may have
   been late because the machine had other work. */
bool trial_waited(void);

/* Whether the last test was ended by a sanitizer that had found a mistake,
   and not by the limit of its memory. */
bool trial_mistake(void);

/* Whether the sanitizers, when a test had passed, have printed that memory
   was lost which source had asked for; if so, tells of it. */
bool trial_leak(const char *prints, const char *source, FILE *story);

#endif
