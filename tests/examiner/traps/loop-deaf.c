/* timed out: it computes for ever and ignores the signal */
/* seconds: 2 */
#include <signal.h>

double twice(double x)
{
    volatile int turning = 1;
    signal(SIGXCPU, SIG_IGN);
    while (turning)
        ;
    return 2 * x;
}
