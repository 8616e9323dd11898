/* Puts guards around the outputs of a student's function. */
#ifndef GUARDS_H
#define GUARDS_H

#include "examiner/check.h"

#include <stdbool.h>

/* Returns whether a guard around an output of the current call has changed.
   If so, describes the first change in *overrun. */
bool guards_overrun(struct check_overrun *overrun);

/* Frees the outputs of the last call. */
void guards_clear(void);

#endif
