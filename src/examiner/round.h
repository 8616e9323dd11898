/* A round through the exercises: lines, a story, the next step. */
#ifndef ROUND_H
#define ROUND_H

#include "examiner/verdict.h"

/* Finds out how the chosen exercises stand, with a line for each, then
   tells a story and what to do next. Those that were named are all told.
   Returns whether all that is begun passes; exits with 2 after a signal. */
bool round_check(struct course *course, const struct verdict_rules *rules,
                 bool named);

/* Finds out how all of them stand, silently. */
void round_learn(struct course *course, const struct verdict_rules *rules);

/* One line: number, title, state, points and minutes. */
void round_line(const struct exercise *e);

/* What there is to say about it, under a head line. */
void round_story(const struct exercise *e);

/* Where an exercise passes and its solution is there: the command. */
void round_solution(const struct exercise *e);

/* The exercise to work on next, or NULL when all of them pass. */
const struct exercise *round_current(const struct course *course);

/* Says which one that is, and the command to type. */
void round_next(const struct course *course);

/* A bar for each chapter, and what comes next. */
void round_progress(const struct course *course);

#endif
