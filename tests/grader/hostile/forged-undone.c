/* not begun: it says that it has not been begun, in a line of its choice */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

static void trick(void)
{
    if (write(4, "u\377\377\377\377", 5) != 5)
        _exit(7);
}
