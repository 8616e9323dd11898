/* crashed: it leaves with the status of a sanitizer */
/* earns: all but the first */
#include "exercise.h"
#include <stdio.h>
#include <unistd.h>

static void trick(void)
{
    fputs("AddressSanitizer: heap-use-after-free\n", stderr);
    _exit(86);
}
