/* passed: it looks whether its thread is done until it is, and ends */
/* earns: all */
#include "exercise.h"
#include <pthread.h>
#include <time.h>

static volatile int done;

/* Half a second of the processor's, which is not the thread's. */
static void *wait_half_a_second(void *nothing)
{
    const struct timespec nap = {0, 10000000};
    while (clock() < CLOCKS_PER_SEC / 2)
        nanosleep(&nap, 0);
    done = 1;
    return nothing;
}

static void trick(void)
{
    pthread_t thread;
    if (pthread_create(&thread, 0, wait_half_a_second, 0) == 0)
        while (!done)
            ;
}
