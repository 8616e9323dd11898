/* timed out: a loop without end, deaf to the signal of the limit on time */
/* earns: all but the first */
#include "exercise.h"
#include <signal.h>

static void trick(void)
{
    signal(SIGXCPU, SIG_IGN);
    for (volatile unsigned long i = 0;; ++i)
        ;
}
