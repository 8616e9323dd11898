/* crashed: it asks its judge to call a function that there is not */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

static void trick(void)
{
    if (write(4, "q\377\377\377\377", 5) != 5)
        _exit(7);
}
