/* crashed: it says that there is nobody */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

static void trick(void)
{
    if (write(4, "x", 1) != 1)
        _exit(7);
}
