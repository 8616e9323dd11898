/* passed: it prints as much as it can, deaf to the signal, and answers */
/* earns: all */
#include "exercise.h"
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static void trick(void)
{
    struct stat about;
    static char line[4096];
    signal(SIGXFSZ, SIG_IGN);
    for (int i = 0; i < 4096; ++i)
        line[i] = 'x';
    for (int i = 0; i < 50000; ++i)
        if (write(i % 2 + 1, line, sizeof line) < 0)
            break;
    if (ftruncate(1, 1 << 30) == 0 ||
        (fstat(1, &about) == 0 && about.st_size > 1 << 20))
        abort(); /* which is seen; what it prints would not be */
}
