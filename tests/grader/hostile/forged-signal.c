/* timed out: it says that a signal has stopped it, which stops its judge */
/* earns: all but the first */
#include "exercise.h"
#include <signal.h>
#include <unistd.h>

static void trick(void)
{
    const char word[9] = {'e', SIGSTOP};
    if (write(4, word, 9) != 9)
        _exit(7);
}
