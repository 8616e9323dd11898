/* timed out: it stops itself */
/* earns: all but the first */
#include "exercise.h"
#include <signal.h>

static void trick(void)
{
    raise(SIGSTOP);
}
