/* timed out: a loop without end before main begins */
/* earns: nothing */
#include "exercise.h"

__attribute__((constructor)) static void before(void)
{
    for (volatile unsigned long i = 0;; ++i)
        ;
}
