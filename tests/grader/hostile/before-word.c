/* failed: before main it says everything that a driver could say */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

__attribute__((constructor)) static void before(void)
{
    if (write(4, "hroqube\0\0\0\0", 11) != 11)
        _exit(7);
}
