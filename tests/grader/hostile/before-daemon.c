/* passed: before main it leaves a process behind that lives on */
/* earns: all */
#define _GNU_SOURCE
#include "exercise.h"
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

__attribute__((constructor)) static void before(void)
{
    if (fork() != 0)
        return;
    setsid();
    if (fork() != 0)
        _exit(0);
    prctl(PR_SET_NAME, "bonkers-left", 0, 0, 0);
    for (int i = 1; i < 64; ++i)
        signal(i, SIG_IGN);
    for (;;)
        pause();
}
