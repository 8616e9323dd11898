/* The marks of one exercise of one student. */
#ifndef MARKS_H
#define MARKS_H

#include "examiner/trial.h"

#include <stdbool.h>
#include <stddef.h>

/* One test, as it was run for one student. Points for tests that a student
   knows and points for hidden ones are told apart to the end: of the latter
   he learns no more than that there are some. */
struct mark {
    char *name;
    bool hidden;      /* with inputs that are not to be shown */
    int points;       /* that it can earn; it earns them if it passes */
    enum state state; /* PASSED, FAILED, ...; NOT_BEGUN if it was not run */
    char *story;      /* for whoever may see it: what the examiner says */
    double seconds;   /* on the wall, of both tries if there were two */
};

enum { MARKS_MOST = 96 };

/* One exercise of one student. Texts are UTF-8 without control characters
   other than line breaks; none is NULL. It is also written to a file as
   soon as it is known, and reports are made from the files alone, so that a
   batch that was interrupted goes on and a new report needs no new
   grading. */
struct marks {
    char *student;    /* the name of the folder */
    char *exercise;   /* "01a" */
    char *title;      /* of the exercise */
    char *file;       /* that was graded, or "no file" */
    char *note;       /* what a person should know of it; else empty */
    enum state state; /* of the whole: the first that is wrong */
    int count;
    struct mark marks[MARKS_MOST];
    char *story;    /* of the compiler, if it refused; else empty */
    char *prints;   /* what the program printed, cut */
    char *advice;   /* of the sanitizers; earns and loses nothing */
    double seconds; /* on the wall, the build included */
    double build_seconds;
    int tries; /* 2 when a time-out was tried again alone */
    bool late; /* the wall's clock has stopped the build or a test */
};

/* The points that were earned, and that can be: of the tests that are
   hidden, or of those that are not. */
int marks_earned(const struct marks *marks, bool hidden);
int marks_possible(const struct marks *marks, bool hidden);

/* Whether a test has timed out, or the build has. */
bool marks_late(const struct marks *marks);

/* Returns bytes escaped, as text_escaped does. Of more than `most` bytes
   the first are kept, and how many there were is said. The caller frees
   it. */
char *marks_text(const char *bytes, size_t length, size_t most);

/* Writes marks to a file, which is there whole or not at all. The key says
   what they depend on. Exits with status 2 when it cannot. */
void marks_write(const struct marks *marks, const char *key,
                 const char *path);

/* Reads them again, if the file is there and has that key (or any key, for
   NULL). Returns whether it has. */
bool marks_read(struct marks *marks, const char *key, const char *path);

/* Frees what marks_read has made. */
void marks_free(struct marks *marks);

#endif
