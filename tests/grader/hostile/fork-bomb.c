/* timed out: it forks without end */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

static void trick(void)
{
    for (;;)
        fork();
}
