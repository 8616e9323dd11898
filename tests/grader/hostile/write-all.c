/* crashed: it writes rubbish to every descriptor there is */
/* earns: all but the first */
#include "exercise.h"
#include <unistd.h>

static void trick(void)
{
    char rubbish[300];
    for (int i = 0; i < 300; ++i)
        rubbish[i] = (char)(255 - i);
    for (int file = 0; file < 64; ++file)
        if (write(file, rubbish, sizeof rubbish) < 0)
            continue;
}
