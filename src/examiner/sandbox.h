/* Sandboxes, in which students' programs are built and run. */
#ifndef SANDBOX_H
#define SANDBOX_H

#include <stdbool.h>
#include <stddef.h>

/* The kinds of sandboxes, best first, in which order they are tried: a
   container may refuse new namespaces, an older kernel cannot keep a
   program from making further ones, and only root can give a program
   another user. Without any of them only limits hold, and a lecturer has
   to ask for that with --unsafe. */
enum sandbox_kind {
    SANDBOX_SEALED, /* namespaces of its own; it cannot make others */
    SANDBOX_USER,   /* the same, but it could make others */
    SANDBOX_ROOT,   /* made by root: users may not make any */
    SANDBOX_NONE    /* no sandbox: limits only */
};

/* What is built and run in a sandbox. The descriptors are open files,
   which each sandbox reads from the beginning; the program itself does not
   get them. */
struct sandbox_order {
    enum sandbox_kind kind;
    const char *name;     /* name of the file, "exercises/01a-x.c" */
    int source;           /* the student's file */
    const char *included; /* name of the header, "kit/exercise.h" */
    int header;           /* the header */
    int inside; /* the driver and the remote calls of the exercise */
    const char *compiler; /* command and flags, split at blanks */
    const char *terse;    /* flag: quote no source lines */
    const char *lean;     /* flags: less for debuggers */
    const char *linker;   /* command that links fast, or empty */
    const char *types;    /* header to include first, or "" */
    const char *keep;     /* options of objcopy: symbols to keep */
    bool sanitized;       /* compiled with sanitizers */
    int seconds;          /* of processor time, for each test */
};

/* A sandbox with a program that runs. */
struct sandbox {
    int requests, answers; /* our ends of the two pipes */
    int prints;            /* file to which all in it print */
    double build_seconds;  /* time to compile and link */
    int test_ms;           /* processor time of the last test */
};

/* How far a sandbox got. */
enum sandbox_stage {
    SANDBOX_NOT_BUILT, /* the compiler or the linker refused */
    SANDBOX_TOO_LONG,  /* compiler or linker took too long */
    SANDBOX_NO_MAIN,   /* the program ended before its main */
    SANDBOX_STUCK,     /* it did not reach its main in time */
    SANDBOX_READY
};

/* Returns the best kind of sandbox that this machine allows, SANDBOX_NONE
   if none. Exits with status 2 when the compiler cannot be started in it.
 */
enum sandbox_kind sandbox_probe(const char *compiler);

/* Returns a user id that belongs to nobody, which the judges of this
   process are to take, or 0 if we are not root and they keep ours. */
long sandbox_judge(void);

/* "namespaces, sealed", ...: what to tell the lecturer. */
const char *sandbox_name(enum sandbox_kind kind);

/* Builds and starts a program in a new sandbox; prints is an empty file,
   open to append. One sandbox at a time. Exits with status 2 when no
   process can be started. */
enum sandbox_stage sandbox_open(struct sandbox *sandbox,
                                const struct sandbox_order *order,
                                int prints);

/* Ends the process of the present test. Returns whether the sandbox can be
   used for another one. */
bool sandbox_settle(struct sandbox *sandbox);

/* Kills all processes in the sandbox and removes it. */
void sandbox_close(struct sandbox *sandbox);

/* How the drawing of a figure ended. */
enum sandbox_drawing {
    SANDBOX_DRAWN,      /* gnuplot has ended, with a figure or not */
    SANDBOX_NO_PROGRAM, /* the compiler or the linker refused */
    SANDBOX_NO_GNUPLOT,
    SANDBOX_DRAWS_LATE /* it was stopped */
};

/* Builds the project of the order in a sandbox of its own and has gnuplot
   run a script, an open file, beside the program. Of the file P1.png that
   is left there at most `room` bytes are taken, and *length says how many.
   prints as for sandbox_open. */
enum sandbox_drawing sandbox_draw(const struct sandbox_order *order,
                                  int script, int prints, char *figure,
                                  size_t room, size_t *length);

#endif
