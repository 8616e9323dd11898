/* passed: it asks whether its child has ended until it has, and ends */
/* earns: all */
#include "exercise.h"
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static void trick(void)
{
    const struct timespec nap = {0, 300000000};
    const pid_t child = fork();
    if (child == 0) {
        nanosleep(&nap, 0);
        _exit(0);
    }
    while (waitpid(child, 0, WNOHANG) == 0)
        ;
}
