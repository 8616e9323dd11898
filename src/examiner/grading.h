/* Grades one student's answer to one exercise. */
#ifndef GRADING_H
#define GRADING_H

#include "examiner/sandbox.h"
#include "examiner/marks.h"

#include <stddef.h>
#include <stdint.h>

struct kit_test {
    char *name;
    int number; /* number of the test in the judge, from 1 */
    int points;
    bool hidden; /* run with the grader's seed */
    bool idle;   /* an empty function passes it */
};

/* An exercise that can be graded. */
struct kit {
    char exercise[4]; /* "01a" */
    char *title;
    char *file; /* "01a-collide.c" */
    int count;
    struct kit_test tests[MARKS_MOST];
};

struct grading {
    const char *root; /* absolute path of the kit */
    const char *work; /* absolute path for temporary folders */
    enum sandbox_kind kind;
    uint64_t seed;              /* seed of the hidden tests */
    int seconds;                /* limit on processor time per test, s */
    const struct marks *before; /* the marks of the first try, or NULL */
    struct grading_page *page;  /* the figure of a project, or NULL */
};

/* The figure of a project. */
struct grading_page {
    char *script; /* the script for gnuplot, or NULL */
    size_t length;
    char *refusal;     /* why the script was refused, or NULL */
    const char *place; /* path of the figure, for the note */
    char *figure;      /* a PNG file; NULL: the note says why */
    size_t drawn;      /* size of the figure, bytes */
};

/* Reads the lists of tests in build/grade into *kits. Returns the number of
   exercises. Exits with status 2 if a list is damaged or none exists. */
size_t grading_kits(struct kit **kits);

/* Grades a student's file as an answer to the exercise `kit`. `bytes` is
   the content of the file, or NULL if there is none. Sets the state, the
   tests, the texts and the times of *marks. Changes the working folder, so
   it must be called in a process of its own. */
void grading_run(const struct grading *grading, const struct kit *kit,
                 const char *bytes, size_t length, struct marks *marks);

#endif
