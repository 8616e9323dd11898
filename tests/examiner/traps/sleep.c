/* timed out: it waits for ever */
#include <unistd.h>

double twice(double x)
{
    for (;;)
        pause();
    return 2 * x;
}
