/* Allocates doubles, aligned to cache lines. */
#include "toolbox/aligned.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Allocates one byte for n = 0, so that NULL always means that memory has
   run out; otherwise no more than requested, so that a sanitizer detects a
   read beyond the end. */
double *aligned_doubles(size_t n)
{
    void *memory;
    if (n > SIZE_MAX / sizeof(double) ||
        posix_memalign(&memory, ALIGNED_LINE,
                       n > 0 ? n * sizeof(double) : 1))
        return NULL;
    return memset(memory, 0, n * sizeof(double));
}
