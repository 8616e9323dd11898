/* Memory aligned to cache lines. */
/* A vector of eight doubles that is not aligned to a cache line lies across
   two lines and is loaded or, worse, stored in two pieces; malloc aligns to
   16 bytes only. Springs read four such arrays in every step. */
#ifndef TOOLBOX_ALIGNED_H
#define TOOLBOX_ALIGNED_H

#include <stddef.h>

enum { ALIGNED_LINE = 64 }; /* size of a cache line, bytes */

/* Returns n doubles, all 0, aligned to a cache line, to be freed with
   free(); NULL if memory runs out. */
double *aligned_doubles(size_t n);

#endif
