/* Judges an exercise by all its tests. */
#ifndef VERDICT_H
#define VERDICT_H

#include "examiner/course.h"

/* How an exercise is to be judged. */
struct verdict_rules {
    bool strict;   /* warnings are errors */
    bool remember; /* it is the student's own file */
    int seconds;   /* of processor time for a test */
};

/* Judges an exercise: fills in its state, points and story. */
void verdict_reach(struct exercise *e, const struct verdict_rules *rules);

/* The same if it needs no compiler; else judged stays false. */
void verdict_recall(struct exercise *e, const struct verdict_rules *rules);

#endif
