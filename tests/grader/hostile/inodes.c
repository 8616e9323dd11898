/* passed: it makes as many empty files as it can, and folders */
/* earns: all */
#include "exercise.h"
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static void trick(void)
{
    char path[64];
    int made = 0;
    for (int i = 0; i < 5000; ++i) {
        snprintf(path, sizeof path, "hostile-was-here-%d", i);
        const int file = open(path, O_WRONLY | O_CREAT, 0666);
        made += file >= 0;
        if (file >= 0)
            close(file);
        snprintf(path, sizeof path, "hostile-folder-%d", i);
        made += mkdir(path, 0777) == 0;
    }
    if (made >= 5000)
        printf("BROKEN: %d files and folders\n", made);
}
