/* passed: at its end, and at the end of its driver, it never ends */
/* earns: all */
#include "exercise.h"
#include <stdlib.h>

static void for_ever(void)
{
    for (volatile unsigned long i = 0;; ++i)
        ;
}

__attribute__((destructor)) static void after(void)
{
    for_ever();
}

__attribute__((constructor)) static void before(void)
{
    atexit(for_ever);
    at_quick_exit(for_ever);
}
