/* Holds the marks of one student for one exercise. */
#ifndef MARKS_H
#define MARKS_H

#include "examiner/trial.h"

#include <stdbool.h>
#include <stddef.h>

/* The result of one test for one student. The points of public and hidden
   tests are always kept apart: students may know only that hidden tests
   exist. */
struct mark {
    char *name;
    bool hidden; /* inputs must not be shown */
    int points;
    enum state state; /* NOT_BEGUN also if it was not run */
    char *story;      /* the examiner's report on the test */
    double seconds;   /* wall-clock time of all tries, s */
};

enum { MARKS_MOST = 96 };

/* The result of one exercise for one student. The texts are UTF-8, without
   control characters except line ends, and none is NULL. Each result is
   written to a file immediately, and reports are made only from these
   files. So an interrupted run of the grader can be continued, and a new
   report needs no new grading. */
struct marks {
    char *student;  /* name of the student's folder */
    char *exercise; /* "01a" */
    char *title;
    char *file;       /* the file that was graded, or "no file" */
    char *note;       /* a note for the lecturer, or "" */
    enum state state; /* state of the first wrong test */
    int count;
    struct mark marks[MARKS_MOST];
    char *story;    /* messages of the compiler, or "" */
    char *prints;   /* the beginning of the program's output */
    char *advice;   /* findings of sanitizers that cost no points */
    double seconds; /* wall-clock time including the build, s */
    double build_seconds;
    int tries; /* 2 if run again after a time-out */
    bool late; /* a limit on wall-clock time was reached */
};

/* Return the points earned or the points possible: in the hidden tests if
   `hidden` is true, otherwise in the public tests. */
int marks_earned(const struct marks *marks, bool hidden);
int marks_possible(const struct marks *marks, bool hidden);

/* Returns whether the build or a test has timed out. */
bool marks_late(const struct marks *marks);

/* Returns bytes as text, escaped by text_escaped; the caller frees it.
   Keeps only the first `most` bytes; if there are more, the text ends with
   a line that gives the total number of bytes. */
char *marks_text(const char *bytes, size_t length, size_t most);

/* Writes marks to a file. `key` is a checksum of everything that the marks
   depend on. Exits with status 2 if the file cannot be written. */
void marks_write(const struct marks *marks, const char *key,
                 const char *path);

/* Reads marks from a file. Returns false, with nothing to free, if the file
   is missing, damaged, or has another key. If `key` is NULL any key will
   do. */
bool marks_read(struct marks *marks, const char *key, const char *path);

/* Frees the texts of *marks and sets all of it to zero. */
void marks_free(struct marks *marks);

#endif
