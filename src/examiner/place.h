/* Guards around the outputs of a student's function. */
#ifndef PLACE_H
#define PLACE_H

#include "examiner/check.h"

#include <stdbool.h>

/* Returns whether a guard of this call's outputs has changed, and describes
   the first that has. */
bool place_look(struct check_overrun *overrun);

/* Frees the outputs of the last call. */
void place_clear(void);

#endif
