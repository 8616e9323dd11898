/* passed: it takes the rights to read from what it prints to */
/* earns: all */
#include "exercise.h"
#include <stdio.h>
#include <sys/stat.h>

static void trick(void)
{
    puts("you will not read this");
    fflush(stdout);
    fchmod(1, 0);
}
