/* crashed: it says that its process has ended well */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

static void trick(void)
{
    if (write(4, "e\0\0\0\0\0\0\0\0", 9) != 9)
        _exit(7);
}
