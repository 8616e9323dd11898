/* crashed: it fills the pipe from which its driver should be told */
/* earns: all but the first */
#define _GNU_SOURCE
#include "exercise.h"
#include <fcntl.h>
#include <unistd.h>

static void trick(void)
{
    static char rubbish[4096];
    const int file = open("/proc/self/fd/3", O_WRONLY | O_NONBLOCK);
    fcntl(3, F_SETPIPE_SZ, 4096);
    while (file >= 0 && write(file, rubbish, sizeof rubbish) > 0)
        ;
    _exit(7);
}
