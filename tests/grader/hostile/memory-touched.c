/* crashed: it allocates without end and writes to all of it */
/* earns: all but the first */
#include "exercise.h"
#include <stdlib.h>
#include <string.h>

static void trick(void)
{
    for (;;)
        memset(malloc(1 << 24), 1, 1 << 24);
}
