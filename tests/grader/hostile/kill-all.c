/* crashed: it kills all that it can see, which is only its driver */
/* earns: all but the first */
#include "exercise.h"
#include <signal.h>
#include <unistd.h>

static void trick(void)
{
    kill(-1, SIGKILL);
    for (;;)
        pause();
}
