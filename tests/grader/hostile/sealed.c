/* passed: it tries to make a sandbox in its sandbox */
/* earns: all */
#define _GNU_SOURCE
#include "exercise.h"
#include <sched.h>
#include <stdio.h>

static void trick(void)
{
    if (unshare(CLONE_NEWUSER) == 0)
        printf("BROKEN: it could make a namespace of users\n");
}
