/* Newton's method for the stages of an implicit step. */
#ifndef NEWTON_H
#define NEWTON_H

#include "forces/stepping.h"

/* Finds the accelerations at the stages, the zero of F in (8.12,
   eq:newton), starting from the guess in s->part->stage. Returns false if
   the iteration does not converge, memory runs out, or there are more than
   1024 unknowns. */
bool newton_solve(struct stepping *s);

#endif
