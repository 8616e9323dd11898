/* crashed: it closes every descriptor there is */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

static void trick(void)
{
    for (int file = 0; file < 1024; ++file)
        close(file);
}
