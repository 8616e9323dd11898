/* timed out: it sleeps, which takes no processor time */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

static void trick(void)
{
    for (;;)
        pause();
}
