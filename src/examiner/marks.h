/* The marks of one exercise of one student. */
#ifndef MARKS_H
#define MARKS_H

#include "examiner/trial.h"

#include <stdbool.h>
#include <stddef.h>

/* The result of one test for one student. Points of public and of hidden
   tests are kept apart throughout: a student learns only that there are
   hidden tests. */
struct mark {
    char *name;
    bool hidden;      /* inputs must not be shown */
    int points;       /* points for passing */
    enum state state; /* NOT_BEGUN: it was not run */
    char *story;      /* the examiner's report on it */
    double seconds;   /* wall-clock time of all its tries, s */
};

enum { MARKS_MOST = 96 };

/* The result of one exercise for one student. Texts are UTF-8 without
   control characters other than line ends; none is NULL. Each result is
   written to a file at once, and reports are made from the files alone: so
   an interrupted batch can go on, and a new report needs no new grading. */
struct marks {
    char *student;    /* name of the student's folder */
    char *exercise;   /* "01a" */
    char *title;      /* title of the exercise */
    char *file;       /* the file that was graded, or "no file" */
    char *note;       /* a note for the lecturer, or "" */
    enum state state; /* state of the first test that is wrong */
    int count;
    struct mark marks[MARKS_MOST];
    char *story;    /* messages of the compiler, or "" */
    char *prints;   /* the beginning of what the program printed */
    char *advice;   /* findings of sanitizers; cost no points */
    double seconds; /* wall-clock time, build included, s */
    double build_seconds;
    int tries; /* 2 if run again after a time-out */
    bool late; /* the limit of wall-clock time was reached */
};

/* Return the points that were earned, and that can be earned, in the hidden
   tests or in the others. */
int marks_earned(const struct marks *marks, bool hidden);
int marks_possible(const struct marks *marks, bool hidden);

/* Returns whether the build or a test has timed out. */
bool marks_late(const struct marks *marks);

/* Returns bytes escaped, as text_escaped does, for the caller to free. Only
   the first `most` bytes are kept; then the text ends with the number of
   all. */
char *marks_text(const char *bytes, size_t length, size_t most);

/* Writes marks to a file, with the key, a checksum of all they depend on.
   Exits with status 2 when it cannot. */
void marks_write(const struct marks *marks, const char *key,
                 const char *path);

/* Reads marks from a file with this key (NULL: any key). Returns whether
   there were any. */
bool marks_read(struct marks *marks, const char *key, const char *path);

/* Frees what marks_read has made. */
void marks_free(struct marks *marks);

#endif
