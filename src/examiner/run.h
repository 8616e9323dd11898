/* Runs a project, a student's whole program, and reads its table. */
#ifndef RUN_H
#define RUN_H

#include <stdbool.h>
#include <stddef.h>

enum {
    RUN_WORDS = 8,          /* most arguments, with the NULL */
    RUN_FILES = 2,          /* most files */
    RUN_PRINTS = 16000000,  /* most bytes that a run may print */
    RUN_COMPLAINT = 1 << 14 /* bytes kept of standard error */
};

/* How calls of the function that a project is given are counted. */
enum run_count {
    RUN_UNCOUNTED,
    RUN_INSIDE, /* by the function, in shared memory */
    RUN_OUTSIDE /* in another process, which alone knows the law's constant:
                   the program can neither change the count nor do without
                 */
};

enum {
    RUN_COUNTER = 3, /* the descriptor of that memory, or of that process */
    RUN_BODIES = 64  /* most bodies in a question */
};

/* A run of `P1 ARGUMENTS`, or whatever the project is called, in a folder
   with these files and no others. */
struct run_order {
    const char *arguments[RUN_WORDS]; /* ends with NULL */
    struct run_file {
        const char *name, *text;
    } files[RUN_FILES]; /* unused ones have no name */
    int given;          /* number of the function to link with */
    enum run_count count;
    double constant;  /* of the law, with RUN_OUTSIDE */
    double most;      /* most calls that are answered there */
    const char *late; /* question if it does not end in time */
};

/* The table that a program printed, and how it ended. A table is rows of
   equally many numbers, then lines that begin with #; from the first other
   line on it is broken, and the suite shows that line. */
struct run {
    int status;           /* exit status */
    bool flooded;         /* it printed more than RUN_PRINTS */
    size_t rows, columns; /* of numbers */
    double *numbers;      /* row by row */
    const char *broken;   /* the first line that is neither, or "" */
    char *remarks;        /* the lines that begin with a # */
    char *complaint;      /* what it wrote to standard error */
    double calls;         /* calls of the function, or -1 */
};

/* Runs the program. The result is valid until the next call. A program
   that crashes, or does not end in time, ends the test. */
const struct run *run_program(const struct run_order *order);

/* Returns the command and its files in one line, for CHECK_NEAR's
   .input. */
const char *run_text(const struct run_order *order);

/* Finds the remark that begins with these words and reads up to count
   numbers behind them; returns how many there are. */
int run_remark(const struct run *run, const char *words, double x[],
               int count);

/* Defined by a project whose calls are counted outside, with
   REMOTE_SERVER: the forces on n bodies by law number `which`. */
void run_law(int which, double constant, int n, const double m[],
             const double x[], double f[]);

/* The server's side: receives an order, runs it, and sends the result. */
void remote_serve(void);

#endif
