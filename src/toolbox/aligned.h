/* Memory aligned to lines of the cache. */
/* A vector of eight doubles that begins elsewhere lies across two lines and
   is loaded, or worse, stored in two pieces; malloc promises only 16 bytes.
   The springs go through four arrays of coordinates in every step. */
#ifndef TOOLBOX_ALIGNED_H
#define TOOLBOX_ALIGNED_H

#include <stddef.h>

enum { ALIGNED_LINE = 64 }; /* bytes */

/* Returns n doubles, all 0, that begin with a line of the cache, to be
   freed with free(); NULL if there is no memory. */
double *aligned_doubles(size_t n);

#endif
