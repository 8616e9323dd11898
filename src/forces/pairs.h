/* How spheres.c finds its pairs; private to it. */
#ifndef PAIRS_H
#define PAIRS_H

#include "forces/spheres.h"

/* Prepares to find pairs of the bodies of p->scene. Returns false if memory
   runs out; pairs_end frees what there is. */
bool pairs_begin(struct spheres *p);
void pairs_end(struct spheres *p);

/* Finds the pairs that overlap after a step, or may overlap when their turn
   comes: p->pair, p->pairs of them, each once, in p->order. Counts in
   p->passed those that the step took through each other. If there is no
   memory for a pair, that pair waits for the next step. */
void pairs_find(struct spheres *p, const double x[], const double v[]);

#endif
