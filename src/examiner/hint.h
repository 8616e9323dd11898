/* Gives hints one at a time. */
#ifndef HINT_H
#define HINT_H

#include "examiner/course.h"

/* Shows the next hint and stores its number. Exits with status 2 if the
   exercise has no hints. */
void hint_show(const struct exercise *e);

/* Resets the number of hints given for this exercise to 0. */
void hint_forget(const struct exercise *e);

#endif
