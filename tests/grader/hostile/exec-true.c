/* crashed: it becomes another program that ends well */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

static void trick(void)
{
    execl("/usr/bin/true", "true", (char *)0);
}
