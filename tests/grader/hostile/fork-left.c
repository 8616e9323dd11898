/* passed: it leaves behind as many children as it can get, and answers */
/* earns: all */
#define _GNU_SOURCE
#include "exercise.h"
#include <sys/prctl.h>
#include <unistd.h>

static void trick(void)
{
    for (int i = 0; i < 8; ++i)
        if (fork() == 0) {
            setsid();
            prctl(PR_SET_NAME, "bonkers-left", 0, 0, 0);
            for (;;)
                pause();
        }
}
