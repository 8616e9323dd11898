/* Runs a project, a student's whole program, and reads its table. */
#ifndef RUN_H
#define RUN_H

#include <stdbool.h>
#include <stddef.h>

enum {
    RUN_WORDS = 8, /* maximum number of arguments, including the NULL */
    RUN_FILES = 2,
    RUN_PRINTS = 16000000,  /* limit on the output of a run, bytes */
    RUN_COMPLAINT = 1 << 14 /* bytes of standard error that are kept */
};

/* How to count the calls of the function that the kit gives to a
   project. */
enum run_count {
    RUN_UNCOUNTED,
    RUN_INSIDE, /* by the function itself, in shared memory */
    RUN_OUTSIDE /* by another process: only that process knows the constant
                   of the law, so the program must ask it for each value */
};

enum {
    RUN_COUNTER = 3, /* descriptor of the shared memory, or of the socket to
                        the other process */
    RUN_BODIES = 64  /* maximum number of bodies in a call */
};

/* An order to run a project, as `P1 ARGUMENTS`, in a folder that contains
   only these files. */
struct run_order {
    const char *arguments[RUN_WORDS]; /* ends with NULL */
    struct run_file {
        const char *name, *text;
    } files[RUN_FILES]; /* an unused entry has no name */
    int given;          /* number of the function to link */
    enum run_count count;
    double constant;  /* constant of the force law, for RUN_OUTSIDE */
    double most;      /* maximum number of calls, for RUN_OUTSIDE */
    const char *late; /* question after a time-out */
};

/* The table that a program printed, and how the program ended. A table
   consists of rows, which all have the same number of columns, and of
   remarks, which begin with #. Any other line is an error. */
struct run {
    int status;
    bool flooded; /* more than RUN_PRINTS was printed */
    size_t rows, columns;
    double *numbers;    /* all rows, one after the other */
    const char *broken; /* the first line in error, or "" */
    bool glued;    /* no blank separates the first two numbers of `broken`,
                      which is then only the end of the line */
    char *remarks; /* the lines that begin with a # */
    char *complaint; /* output on standard error */
    double calls;    /* calls of the function; -1: unknown */
};

/* Runs the program as ordered. Checks that fail then report this order as
   their input. The result is valid until the next call. Ends the test if
   the program crashes or does not end in time. */
const struct run *run_program(const struct run_order *order);

/* Returns the command and its files in one line, the form in which checks
   report it, so that a student can repeat a run that failed. */
const char *run_text(const struct run_order *order);

/* Finds the remark that begins with `words` and reads up to `count` numbers
   after them into x. Returns how many it has read. */
int run_remark(const struct run *run, const char *words, double x[],
               int count);

/* Sets f to the forces on n bodies with masses m and positions x, according
   to force law `which` with this constant. A project whose calls are
   counted outside the sandbox (RUN_OUTSIDE) defines this function if
   compiled with REMOTE_SERVER. */
void run_law(int which, double constant, int n, const double m[],
             const double x[], double f[]);

/* Receives an order, runs it, and sends the result. Called in the
   sandbox. */
void remote_serve(void);

#endif
