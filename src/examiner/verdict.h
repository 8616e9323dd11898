/* Judges an exercise by all its tests. */
#ifndef VERDICT_H
#define VERDICT_H

#include "examiner/course.h"

/* The rules by which an exercise is judged. */
struct verdict_rules {
    bool strict;    /* warnings are errors */
    bool use_cache; /* read and store verdicts in the cache */
    int seconds;    /* limit on processor time per test, s */
};

/* Judges an exercise: fills in its state, points and report (story). */
void verdict_reach(struct exercise *e, const struct verdict_rules *rules);

/* Judges an exercise if that needs no compiler; otherwise e->judged stays
   false. */
void verdict_from_cache(struct exercise *e,
                        const struct verdict_rules *rules);

#endif
