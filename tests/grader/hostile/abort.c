/* crashed: it gives up */
/* earns: all but the first */
#include "exercise.h"
#include <stdlib.h>

static void trick(void)
{
    abort();
}
