/* passed: a handler that it leaves behind is not part of the test */
#include <stdlib.h>
#include <unistd.h>

static void leave(void)
{
    _exit(1);
}

double twice(double x)
{
    atexit(leave);
    return 2 * x;
}
