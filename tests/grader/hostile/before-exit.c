/* crashed: it ends well before main begins */
/* earns: nothing */
#include "exercise.h"
#include <stdlib.h>

__attribute__((constructor)) static void before(void)
{
    exit(0);
}
