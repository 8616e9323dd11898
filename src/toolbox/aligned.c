/* Allocates doubles that begin with a line of the cache. */
#include "toolbox/aligned.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Takes one byte for n = 0, so that NULL always means that there is no
   memory; otherwise no more than asked for, so that a sanitizer notices a
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
