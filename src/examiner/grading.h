/* Grades one exercise of one student. */
#ifndef GRADING_H
#define GRADING_H

#include "examiner/sandbox.h"
#include "examiner/marks.h"

#include <stddef.h>
#include <stdint.h>

/* A test of an exercise. */
struct kit_test {
    char *name;
    int number; /* the judge's */
    int points;
    bool hidden; /* whether it is run with the grader's seed */
    bool idle; /* passes without work: earns only if another test passes */
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
    const char *root; /* of the project, absolute */
    const char *work; /* a folder for gradings, absolute */
    enum sandbox_kind kind;
    uint64_t seed;              /* of the hidden tests */
    int seconds;                /* of processor time, for each test */
    const struct marks *before; /* of a first try, or NULL */
    struct grading_page *page;  /* of a project, or NULL */
};

/* The figure that a project asks for. */
struct grading_page {
    char *script; /* gnuplot's, or NULL */
    size_t length;
    char *refusal;     /* why it is NULL though there is one, or NULL */
    const char *place; /* where the figure is to stand, for the note */
    char *figure;      /* a PNG, or NULL; the note says why */
    size_t drawn;      /* bytes */
};

/* Reads the lists in build/grade; returns how many exercises there are.
   Exits with status 2 when the lists are missing or damaged. */
size_t grading_kits(struct kit **kits);

/* Grades a file, its bytes given, as an exercise: fills in state, tests,
   texts and times of the marks. Changes the working folder; to be called
   in a process of its own. */
void grading_run(const struct grading *grading, const struct kit *kit,
                 const char *bytes, size_t length, struct marks *marks);

#endif
