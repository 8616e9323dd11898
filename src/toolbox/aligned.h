/* Memory aligned to lines of the cache. */
/* A vector of eight doubles that does not begin with a line of the cache
   lies across two lines and is loaded or, worse, stored in two pieces;
   malloc aligns to 16 bytes only. Springs read four such arrays in every
   step. */
#ifndef TOOLBOX_ALIGNED_H
#define TOOLBOX_ALIGNED_H

#include <stddef.h>

enum { ALIGNED_LINE = 64 }; /* size of a line of the cache, bytes */

/* Returns n doubles, all 0, that begin with a line of the cache, to be
   freed with free(); NULL if there is no memory. */
double *aligned_doubles(size_t n);

#endif
