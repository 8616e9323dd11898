/* timed out: it says that a signal has stopped it, which stops its judge */
/* earns: all but the first */
#include "exercise.h"
#include <signal.h>
#include <unistd.h>

static void trick(void)
{
    const char word[5] = {'e', SIGSTOP};
    if (write(4, word, 5) != 5)
        _exit(7);
}
