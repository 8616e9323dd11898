/* Runs a project, a student's whole program, and reads its table. */
#ifndef RUN_H
#define RUN_H

#include <stdbool.h>
#include <stddef.h>

enum {
    RUN_WORDS = 8,          /* most arguments, the NULL included */
    RUN_FILES = 2,          /* most files */
    RUN_PRINTS = 16000000,  /* most bytes that a run may print */
    RUN_COMPLAINT = 1 << 14 /* bytes kept of standard error */
};

/* The way to count the calls of the function that a project is given. */
enum run_count {
    RUN_UNCOUNTED,
    RUN_INSIDE, /* by the function itself, in shared memory */
    RUN_OUTSIDE /* by another process, which alone knows the law's constant,
                   so that the program must ask it for each value */
};

enum {
    RUN_COUNTER = 3, /* descriptor of that memory, or of that process */
    RUN_BODIES = 64  /* most bodies in a call */
};

/* An order to run `P1 ARGUMENTS`, or another project, in a folder with only
   these files. */
struct run_order {
    const char *arguments[RUN_WORDS]; /* ends with NULL */
    struct run_file {
        const char *name, *text;
    } files[RUN_FILES]; /* unused ones have no name */
    int given;          /* number of the function to link */
    enum run_count count;
    double constant;  /* constant of the law, with RUN_OUTSIDE */
    double most;      /* most calls answered, with RUN_OUTSIDE */
    const char *late; /* question after a time-out */
};

/* The table that a program printed, and how it ended. A table is rows of
   equally many numbers and remarks, lines that begin with #; any other line
   breaks it, and the suite shows the first such line. */
struct run {
    int status;   /* exit status */
    bool flooded; /* more than RUN_PRINTS was printed */
    size_t rows, columns;
    double *numbers;    /* all rows, one after the other */
    const char *broken; /* the first line that breaks it, or "" */
    char *remarks;      /* the lines that begin with a # */
    char *complaint;    /* its output on standard error */
    double calls;       /* calls of the function; -1: unknown */
};

/* Runs the program. The result is valid until the next call. A program
   that crashes, or does not end in time, ends the test. */
const struct run *run_program(const struct run_order *order);

/* Returns the command and its files in one line, for CHECK_NEAR's
   .input. */
const char *run_text(const struct run_order *order);

/* Finds the remark that begins with these words and reads up to count
   numbers after them; returns how many it has read. */
int run_remark(const struct run *run, const char *words, double x[],
               int count);

/* Sets the forces on n bodies by law number `which`; defined, with
   REMOTE_SERVER, by a project whose calls are counted outside. */
void run_law(int which, double constant, int n, const double m[],
             const double x[], double f[]);

/* Receives an order, runs it, and sends the result; on the server's
   side. */
void remote_serve(void);

#endif
