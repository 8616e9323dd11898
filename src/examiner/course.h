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
    const char *usual; /* "01a-collide.c", what its file is called */
    const char *title;
    const char *tests[CHECK_TESTS];
    int worth[CHECK_TESTS]; /* points of each test */
    bool idle[CHECK_TESTS]; /* an empty function passes it */
    int count, minutes, points;
    char file[COURSE_PATH]; /* the student's; empty when it is missing */
    char stub[COURSE_PATH]; /* the file as it came with the book */
    char
        stray[COURSE_PATH]; /* a file that may be the student's, misnamed */
    char solution[COURSE_PATH]; /* the worked one; empty where there is none
                                 */
    bool chosen;                /* the command names it, or names none */
    bool judged;                /* the fields below are set */
    enum state state;
    int earned;  /* points that it has now */
    int gap;     /* the line of a NOT_DONE_YET that was reached, or 0 */
    int wants;   /* number of the first test that did not pass, or 0 */
    char *story; /* what to say about it, or NULL */
};

struct course {
    struct exercise *exercises;
    size_t count;
};

/* Finds the exercises; exits with 2 when the kit is not built or a file
   stands where it must not. */
struct course course_learn(void);

/* Chooses the exercises of a name: "01a", or "01" for a chapter. Returns
   the first; exits with 2, naming those that there are, for another name.
 */
struct exercise *course_choose(struct course *course, const char *name);

/* Sets e->file to the student's file, which may have come or gone. */
void course_find_file(struct exercise *e);

/* Whether the student's file is there and differs from its stub. */
bool course_touched(const struct exercise *e);

#endif
