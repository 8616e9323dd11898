/* The search for overlapping pairs of spheres; private to spheres.c. */
#ifndef PAIRS_H
#define PAIRS_H

#include "forces/spheres.h"

/* Prepares to find pairs of the bodies of p->scene. Returns false if memory
   runs out; pairs_end frees the rest. */
bool pairs_begin(struct spheres *p);
void pairs_end(struct spheres *p);

/* Finds the pairs that overlap after a step, or may overlap when their turn
   comes: p->pairs of them in p->pair, each once, in p->order. Counts in
   p->passed the pairs that the step moved through each other. If memory
   runs out, the remaining pairs wait for the next step. */
void pairs_find(struct spheres *p, const double x[], const double v[]);

#endif
