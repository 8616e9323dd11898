/* The exercises of a course and the student's files for them. */
#ifndef COURSE_H
#define COURSE_H

#include "examiner/check.h"
#include "examiner/trial.h"

#include <stdbool.h>
#include <stddef.h>

enum { COURSE_PATH = 1024 };

/* An exercise, its files and its verdict. */
struct exercise {
    char name[4];      /* "01a" */
    const char *usual; /* usual name of its file, "01a-collide.c" */
    const char *title;
    const char *tests[CHECK_TESTS];
    int worth[CHECK_TESTS]; /* points of each test */
    bool idle[CHECK_TESTS]; /* passed by a function that does nothing */
    int count, minutes, points;
    char file[COURSE_PATH];     /* the student's file; "": none */
    char stub[COURSE_PATH];     /* the original file of the kit */
    char stray[COURSE_PATH];    /* a file with a similar name; "": none */
    char solution[COURSE_PATH]; /* worked solution; "": none */
    bool chosen;                /* to be judged */
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

/* Finds the exercises. Exits with status 2 if the kit is not built, or if
   the file of an exercise is missing, ambiguous or not a plain file. */
struct course course_learn(void);

/* Marks the exercises with this name as chosen: one exercise ("01a") or all
   of a chapter ("01"). Returns the first. If no exercise has this name,
   prints the known names and exits with status 2. */
struct exercise *course_choose(struct course *course, const char *name);

/* Sets e->file to the path of the student's file or, if there is none, sets
   e->file to "" and e->stray to a file with a similar name. */
void course_find_file(struct exercise *e);

/* Returns whether the student's file exists and differs from its stub. */
bool course_touched(const struct exercise *e);

#endif
