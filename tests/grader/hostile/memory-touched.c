/* crashed: it allocates without end and writes to all of it */
/* earns: all but the first */
#include "exercise.h"
#include <stdlib.h>
#include <string.h>

static void *volatile block;

static void trick(void)
{
    for (;;) {
        block = malloc(1 << 24);
        memset(block, 1, 1 << 24);
    }
}
