/* The marks of one exercise of one student. */
#ifndef MARKS_H
#define MARKS_H

#include "examiner/trial.h"

#include <stdbool.h>
#include <stddef.h>

/* One test, as it was run for one student. Points of public and of hidden
   tests are kept apart throughout: of the hidden ones a student learns no
   more than that there are some. */
struct mark {
    char *name;
    bool hidden;      /* its inputs must not be shown */
    int points;       /* earned if it passes */
    enum state state; /* PASSED, FAILED, ...; NOT_BEGUN if it was not run */
    char *story;      /* what the examiner says about it */
    double seconds;   /* wall-clock time, of both tries if two */
};

enum { MARKS_MOST = 96 };

/* One exercise of one student. Texts are UTF-8 without control characters
   other than line ends; none is NULL. Each is written to a file as soon as
   it is known, and reports are made from the files alone: so an
   interrupted batch can go on, and a new report needs no new grading. */
struct marks {
    char *student;    /* the name of the folder */
    char *exercise;   /* "01a" */
    char *title;      /* of the exercise */
    char *file;       /* the file that was graded, or "no file" */
    char *note;       /* what a person should know, or empty */
    enum state state; /* of the exercise: the first that is wrong */
    int count;
    struct mark marks[MARKS_MOST];
    char *story;    /* messages of the compiler, or empty */
    char *prints;   /* the beginning of what the program printed */
    char *advice;   /* what sanitizers found; costs no points */
    double seconds; /* wall-clock time, with the build */
    double build_seconds;
    int tries; /* 2 if a time-out was tried again, alone */
    bool late; /* the wall clock stopped the build or a test */
};

/* Return the points that were earned, and that can be, of the hidden tests
   or of the others. */
int marks_earned(const struct marks *marks, bool hidden);
int marks_possible(const struct marks *marks, bool hidden);

/* Returns whether the build or a test has timed out. */
bool marks_late(const struct marks *marks);

/* Returns bytes escaped, as text_escaped does, for the caller to free.
   Only the first `most` bytes are kept; the text then ends with how many
   there were. */
char *marks_text(const char *bytes, size_t length, size_t most);

/* Writes marks to a file, with the key of what they depend on. Exits with
   status 2 when it cannot. */
void marks_write(const struct marks *marks, const char *key,
                 const char *path);

/* Reads marks from a file with this key (NULL: any key). Returns whether
   there were any. */
bool marks_read(struct marks *marks, const char *key, const char *path);

/* Frees what marks_read has made. */
void marks_free(struct marks *marks);

#endif
