/* Newton's method for the stages of an implicit step. */
#ifndef NEWTON_H
#define NEWTON_H

#include "forces/stepping.h"

/* Solves for the accelerations at the stages, from the guess in
   s->part->stage: the zero of F in (8.12, eq:newton). Returns false if it
   does not converge, if memory runs out, or for more than 1024 unknowns. */
bool newton_solve(struct stepping *s);

#endif
