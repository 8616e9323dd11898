/* timed out: it reads what was meant for its driver */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

static void trick(void)
{
    char bytes[64];
    while (read(3, bytes, sizeof bytes) > 0)
        ;
}
