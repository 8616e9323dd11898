/* A tree of cells for gravity: a distant cell counts as one mass. */
#ifndef TREE_H
#define TREE_H

#include "forces/gravity.h"

#include <stddef.h>

/* Returns a tree for this number of bodies, or NULL if memory runs out. A
   cell is opened unless its width is less than theta times its distance.
   The tree keeps the pointer mass. */
struct tree *tree_create(size_t bodies, const double mass[], double theta);

/* Frees a tree, which may be NULL. */
void tree_free(struct tree *t);

/* Sorts the bodies into cells. x[] has 3 * bodies coordinates, axis by
   axis. The tree depends only on x, not on earlier positions. */
void tree_build(struct tree *t, const double x[]);

/* Adds to a[] the accelerations, due to all bodies, of the block that
   begins with body i in the order of g->tree. tree_build must have built
   the tree from this x. The error is at most (9.15, eq:tree-bound). */
void tree_add(const struct gravity *g, const double x[], double a[],
              size_t i);

#endif
