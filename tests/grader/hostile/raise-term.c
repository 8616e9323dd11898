/* crashed: it sends itself the polite signal */
/* earns: all but the first */
#include "exercise.h"
#include <signal.h>

static void trick(void)
{
    raise(SIGTERM);
}
