/* The exercises of a course, and the student's files for them. */
#ifndef COURSE_H
#define COURSE_H

#include "examiner/check.h"
#include "examiner/trial.h"

#include <stdbool.h>
#include <stddef.h>

enum { COURSE_PATH = 1024 };

/* An exercise and its state. */
struct exercise {
    char name[4];      /* "01a" */
    const char *usual; /* usual name of its file, "01a-collide.c" */
    const char *title;
    const char *tests[CHECK_TESTS];
    int worth[CHECK_TESTS]; /* points of each test */
    bool idle[CHECK_TESTS]; /* whether an empty function passes it */
    int count, minutes, points;
    char file[COURSE_PATH];     /* the student's file; "": missing */
    char stub[COURSE_PATH];     /* the file as the book gives it */
    char stray[COURSE_PATH];    /* perhaps the student's, misnamed */
    char solution[COURSE_PATH]; /* worked solution; "": none */
    bool chosen;                /* to be judged: named, or none is named */
    bool judged;                /* the fields below are set */
    enum state state;
    int earned;  /* points earned */
    int gap;     /* line of the NOT_DONE_YET reached, or 0 */
    int wants;   /* number of the first test not passed, or 0 */
    char *story; /* the report on the exercise, or NULL */
};

struct course {
    struct exercise *exercises;
    size_t count;
};

/* Finds the exercises; exits with 2 when the kit is not built or a file is
   where it must not be. */
struct course course_learn(void);

/* Chooses the exercises of a name: "01a", or "01" for a chapter. Returns
   the first. For another name prints the known ones and exits with 2. */
struct exercise *course_choose(struct course *course, const char *name);

/* Sets e->file to the student's file, if there is one now. */
void course_find_file(struct exercise *e);

/* Returns whether the student's file exists and differs from its stub. */
bool course_touched(const struct exercise *e);

#endif
