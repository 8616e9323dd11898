/* crashed: it leaves with status 0, and nothing else happens */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

static void trick(void)
{
    _exit(0);
}
