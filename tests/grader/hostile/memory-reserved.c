/* passed: it reserves what it can get, writes to nothing, and answers */
/* earns: all */
#include "exercise.h"
#include <stdio.h>
#include <stdlib.h>

static void *volatile last;

static void trick(void)
{
    size_t blocks = 0;
    while (blocks < 4096 && (last = malloc(1 << 20)))
        ++blocks;
    if (blocks > 600)
        printf("BROKEN: %zu MiB reserved\n", blocks);
}
