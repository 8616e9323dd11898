/* crashed: it sends itself a signal that means nothing */
/* earns: all but the first */
#include "exercise.h"
#include <signal.h>

static void trick(void)
{
    raise(SIGUSR1);
}
