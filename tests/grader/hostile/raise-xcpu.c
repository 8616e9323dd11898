/* timed out: it says that its time is over */
/* earns: all but the first */
#include "exercise.h"
#include <signal.h>

static void trick(void)
{
    raise(SIGXCPU);
}
