/* Judges exercises one after the other, and prints results. */
#ifndef ROUND_H
#define ROUND_H

#include "examiner/verdict.h"

/* Judges the chosen exercises and prints a line for each. Then prints the
   report on the first failure or, if `named`, on every exercise that was
   named. Returns whether all exercises begun so far pass. Exits with status
   2 after a signal. */
bool round_check(struct course *course, const struct verdict_rules *rules,
                 bool named);

/* Judges all exercises and prints nothing. */
void round_learn(struct course *course, const struct verdict_rules *rules);

/* Prints a line: number, title, state, points and minutes. */
void round_line(const struct exercise *e);

/* Prints the report on an exercise, under a heading. */
void round_story(const struct exercise *e);

/* Prints the command that shows the solution, if the exercise passes and
   there is one. */
void round_solution(const struct exercise *e);

/* Returns the exercise to work on next, or NULL when all pass. */
const struct exercise *round_current(const struct course *course);

/* Prints the exercise to work on next and the command to type. */
void round_next(const struct course *course);

/* Prints a bar for each chapter and one for the whole course. */
void round_progress(const struct course *course);

#endif
