/* passed: the process of its first test answers, and cannot be sent away */
/* earns: all */
#include "exercise.h"
#include <unistd.h>

static void late(void)
{
    for (;;)
        pause();
}

static void trick(void)
{
    /* The library's fflush at the end of a test reaches this no more. */
    if (fork() == 0)
        late();
    setsid();
}
