/* Gives hints one at a time. */
#ifndef HINT_H
#define HINT_H

#include "examiner/course.h"

/* Shows the next hint and stores its number; exits with 2 if there is
   none. */
void hint_show(const struct exercise *e);

/* Forgets which hints of this exercise were given. */
void hint_forget(const struct exercise *e);

#endif
