/* crashed: it prints 200 MB */
/* earns: all but the first */
#include "exercise.h"
#include <stdio.h>

static void trick(void)
{
    for (int i = 0; i < 20000000; ++i)
        puts("123456789");
}
