/* Builds and runs students' programs in sandboxes. */
#ifndef SANDBOX_H
#define SANDBOX_H

#include <stdbool.h>
#include <stddef.h>

/* The kinds of sandboxes, best first; sandbox_probe tries them in this
   order. An older kernel cannot keep a program from making more namespaces,
   so the first kind may fail. A container may refuse new namespaces to
   users, so the second may fail. The third needs root, since only root can
   give a program another user. If all three fail, only limits protect the
   machine, and a lecturer must ask for that with --unsafe. */
enum sandbox_kind {
    SANDBOX_SEALED, /* own namespaces; the program can make no others */
    SANDBOX_USER,   /* own namespaces; the program could make others */
    SANDBOX_ROOT,   /* namespaces made by root */
    SANDBOX_NONE    /* no sandbox: limits only */
};

/* An order to build and run a program in a sandbox. The descriptors
   `source`, `header` and `inside` are open files, which each sandbox reads
   from the beginning. The program itself does not get them. */
struct sandbox_order {
    enum sandbox_kind kind;
    const char *name;     /* name of the file, "exercises/01a-x.c" */
    int source;           /* the student's file */
    const char *included; /* the header's name, "kit/exercise.h" */
    int header;           /* the header that the stub includes */
    int inside;           /* object with the driver and the remote calls */
    const char *script;   /* text of the script sandbox.sh */
    const char *compiler; /* compiler with flags, split at blanks */
    const char *terse;    /* flag that omits source lines in messages */
    const char *lean;     /* flags for less debugging information */
    const char *linker;   /* command that links fast, or "" */
    const char *types;    /* header to include first, or "" */
    const char *keep;     /* options of objcopy: symbols to keep */
    bool sanitized;       /* compiled with sanitizers */
    int seconds;          /* limit on processor time per test, s */
};

/* A sandbox and the program that runs in it. */
struct sandbox {
    int requests, answers; /* descriptors of our ends of the pipes */
    int prints;            /* file to which all its programs print */
    double build_seconds;  /* time to compile and link, s */
    int test_ms;           /* processor time of the last test, ms */
};

/* The stage that a sandbox has reached. */
enum sandbox_stage {
    SANDBOX_NOT_BUILT, /* the compiler or the linker refused */
    SANDBOX_TOO_LONG,  /* compiler or linker took too long */
    SANDBOX_NO_MAIN,   /* the program ended before it reached main */
    SANDBOX_STUCK,     /* the program did not reach its main in time */
    SANDBOX_READY
};

/* Returns the best kind of sandbox that this machine allows, or
   SANDBOX_NONE. Exits with status 2 if the compiler cannot be started in
   it. */
enum sandbox_kind sandbox_probe(const char *compiler);

/* Returns an unused user ID for the judges of this process, or 0 if we are
   not root. With 0 the judges keep our user ID. */
long sandbox_judge(void);

/* Returns a description of a kind, for the lecturer. */
const char *sandbox_name(enum sandbox_kind kind);

/* Builds and starts a program in a new sandbox. Its output is appended to
   `prints`, an empty file opened for appending. Only one sandbox may be
   open at a time. Exits with status 2 if no process can be started. */
enum sandbox_stage sandbox_open(struct sandbox *sandbox,
                                const struct sandbox_order *order,
                                int prints);

/* Ends the process of the current test. Returns whether the sandbox can be
   used for another test. */
bool sandbox_settle(struct sandbox *sandbox);

/* Kills all processes in the sandbox and removes it. */
void sandbox_close(struct sandbox *sandbox);

/* How the drawing of a figure ended. */
enum sandbox_drawing {
    SANDBOX_DRAWN,      /* gnuplot has ended, perhaps without a figure */
    SANDBOX_NO_PROGRAM, /* the compiler or the linker refused */
    SANDBOX_NO_GNUPLOT,
    SANDBOX_DRAWS_LATE /* gnuplot took too long and was stopped */
};

/* Builds the project of the order in a new sandbox. Then runs the gnuplot
   script in the open file `script`, in a folder with the program. Copies at
   most `room` bytes of the figure, such as P1.png, to `figure` and sets
   *length to their number. `prints` is as for sandbox_open. */
enum sandbox_drawing sandbox_draw(const struct sandbox_order *order,
                                  int script, int prints, char *figure,
                                  size_t room, size_t *length);

#endif
