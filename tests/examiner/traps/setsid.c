/* passed: it leaves a process behind that has left the group */
#include <stdio.h>
#include <sys/types.h>
#include <unistd.h>

double twice(double x)
{
    const pid_t child = fork();
    if (child == 0) {
        setsid();
        for (;;)
            pause();
    }
    FILE *file = fopen("../../../../strays.pid", "a");
    if (file) {
        fprintf(file, "%ld\n", (long)child);
        fclose(file);
    }
    return 2 * x;
}
