/* The search for overlapping pairs of spheres; private to spheres.c. */
#ifndef PAIRS_H
#define PAIRS_H

#include "forces/spheres.h"

/* Prepares to find pairs of the bodies of p->scene. Returns false if memory
   runs out. pairs_end then frees what was allocated. */
bool pairs_begin(struct spheres *p);
void pairs_end(struct spheres *p);

/* Lists in p->pair the pairs that overlap after a step or may overlap when
   their turn comes, each once and in p->order. Sets p->pairs to their
   number. Counts in p->passed the pairs that moved through each other in
   the step. If memory runs out, the remaining pairs are left to the next
   step. */
void pairs_find(struct spheres *p, const double x[], const double v[]);

#endif
