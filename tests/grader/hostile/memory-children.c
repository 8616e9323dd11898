/* passed: children without number hold memory, and it answers */
/* earns: all */
#define _GNU_SOURCE
#include "exercise.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <unistd.h>

static void trick(void)
{
    int children = 0;
    for (int i = 0; i < 100; ++i) {
        const pid_t pid = fork();
        children += pid > 0;
        if (pid == 0) {
            char *block = malloc(1 << 20);
            prctl(PR_SET_NAME, "bonkers-left", 0, 0, 0);
            if (block)
                memset(block, 1, 1 << 20);
            for (;;)
                pause();
        }
    }
    if (children > 40)
        printf("BROKEN: %d children\n", children);
}
