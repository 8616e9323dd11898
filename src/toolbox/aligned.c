/* Allocates arrays of doubles that are aligned to cache lines. */
#include "toolbox/aligned.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* For n = 0 allocates one byte, because NULL must always mean that memory
   has run out. Otherwise allocates no more than requested, to let a
   sanitizer detect a read beyond the end. */
double *aligned_doubles(size_t n)
{
    void *memory;
    if (n > SIZE_MAX / sizeof(double) ||
        posix_memalign(&memory, ALIGNED_LINE,
                       n > 0 ? n * sizeof(double) : 1))
        return NULL;
    return memset(memory, 0, n * sizeof(double));
}
