/* passed: it would write into the memory of its driver */
/* earns: all */
#include "exercise.h"
#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

static void trick(void)
{
    char path[64];
    snprintf(path, sizeof path, "/proc/%ld/mem", (long)getppid());
    if (open(path, O_RDWR) >= 0)
        puts("BROKEN: the driver's memory is open");
}
