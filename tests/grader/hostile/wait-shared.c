/* passed: it looks whether its child has written to memory, and ends */
/* earns: all */
#define _GNU_SOURCE
#include "exercise.h"
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static void trick(void)
{
    const struct timespec nap = {0, 300000000};
    volatile int *done = mmap(0, sizeof *done, PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    const pid_t child = done == MAP_FAILED ? -1 : fork();
    if (child == 0) {
        nanosleep(&nap, 0);
        *done = 1;
        _exit(0);
    }
    while (child > 0 && !*done)
        ;
    waitpid(child, 0, 0);
}
