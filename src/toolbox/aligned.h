/* Memory aligned to cache lines. */
/* A vector of eight doubles that crosses the border of a cache line is
   loaded and stored in two pieces, which is slower. malloc aligns memory to
   16 bytes only. The code for springs reads four such arrays in every
   step. */
#ifndef TOOLBOX_ALIGNED_H
#define TOOLBOX_ALIGNED_H

#include <stddef.h>

enum { ALIGNED_LINE = 64 }; /* size of a cache line, bytes */

/* Allocates n doubles, all 0, aligned to a cache line. The caller frees
   them with free(). Returns NULL if memory runs out. */
double *aligned_doubles(size_t n);

#endif
