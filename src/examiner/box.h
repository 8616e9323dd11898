/* An isolated environment in which a student's program is built and run. */
#ifndef BOX_H
#define BOX_H

#include <stdbool.h>
#include <stddef.h>

/* The kinds of boxes, the best first. A container may refuse new
   namespaces, an older kernel cannot keep a program in a box from making
   boxes itself, and only root can give it another user. So all are tried in
   this order; without any there are only limits, and the lecturer has to
   ask for that in so many words. */
enum box_kind {
    BOX_SEALED, /* namespaces of its own, and no more of them inside */
    BOX_USER,   /* the same, but it may make further ones inside */
    BOX_ROOT,   /* made by root, where users may not make namespaces */
    BOX_OPEN    /* no box: limits only */
};

/* What is built and run in a box. The descriptors are of open files, read
   from their beginning by each box; none is seen by the program itself. */
struct box_order {
    enum box_kind kind;
    const char *name;     /* of the student's file, "exercises/01a-x.c" */
    int source;           /* the student's file */
    const char *included; /* its header, "kit/exercise.h" */
    int header;           /* the same */
    int inside; /* the driver and the remote calls of the exercise */
    const char *compiler; /* with its flags, to be split at blanks */
    const char *terse;    /* the flag with which it quotes no lines */
    const char *lean;     /* and those that leave out what nobody reads */
    const char *linker;   /* how it is first tried to link, or blank */
    const char *types;    /* what is included before its line 1, or "" */
    const char *keep;     /* options of objcopy: the symbols that stay */
    bool sanitized;       /* compiled with sanitizers */
    int seconds;          /* of processor time, for each test */
};

/* A box with a program in it. */
struct box {
    int requests, answers; /* descriptors: ours of the two pipes */
    int prints;            /* where compiler and program print; ours */
    double build_seconds;  /* until it was compiled and linked */
    int test_ms;           /* of the processor, for the test settled last */
};

/* How far a box has come. */
enum box_stage {
    BOX_NOT_BUILT, /* the compiler or the linker refused */
    BOX_TOO_LONG,  /* they were stopped */
    BOX_NO_MAIN,   /* the program ended before its main */
    BOX_STUCK,     /* it did not come to its main in time */
    BOX_READY
};

/* Returns the best kind of box that this machine allows, BOX_OPEN if none.
   Exits with status 2 when the compiler cannot be started in it. */
enum box_kind box_probe(const char *compiler);

/* Returns the number of a user who is nobody's, for the judge of this
   process's boxes, or 0 when we are not root and it keeps ours. */
long box_judge(void);

/* "namespaces, sealed", ...: what to tell the lecturer. */
const char *box_name(enum box_kind kind);

/* Builds the order in a new box and starts it; prints is a file, open to
   append, that is empty. One box at a time. Exits with status 2 when no
   process can be started. */
enum box_stage box_open(struct box *box, const struct box_order *order,
                        int prints);

/* Ends the test that the program in the box has served. Returns whether
   the box is fit for another. */
bool box_settle(struct box *box);

/* Kills all that is in the box, and the box. */
void box_close(struct box *box);

/* What became of a figure. */
enum box_drawing {
    BOX_DRAWN,      /* gnuplot has ended, be there a figure or not */
    BOX_NO_PROGRAM, /* the compiler or the linker refused */
    BOX_NO_GNUPLOT,
    BOX_DRAWS_LATE /* it was stopped */
};

/* Builds the project of the order in a box of its own and has gnuplot run a
   script, an open file, beside the program. Of the file P1.png that is left
   there at most `room` bytes are taken, and *length says how many. prints
   as for box_open. */
enum box_drawing box_draw(const struct box_order *order, int script,
                          int prints, char *figure, size_t room,
                          size_t *length);

#endif
