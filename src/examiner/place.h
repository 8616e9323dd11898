/* Guards around what a student's function may write to. */
#ifndef PLACE_H
#define PLACE_H

#include "examiner/check.h"

#include <stdbool.h>

/* Looks at the guards of all places of this call. Returns whether somebody
   has written to one, and tells of the first. */
bool place_look(struct check_overrun *overrun);

/* Frees the places of the last call. */
void place_clear(void);

#endif
