/* crashed: it kills its driver and its driver's group */
/* earns: all but the first */
#include "exercise.h"
#include <signal.h>
#include <unistd.h>

static void trick(void)
{
    kill(-getpgid(getppid()), SIGKILL);
    kill(getppid(), SIGKILL);
    for (;;)
        pause();
}
