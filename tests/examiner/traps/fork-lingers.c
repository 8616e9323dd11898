/* passed: it leaves a process behind, which is killed */
#include <stdio.h>
#include <sys/types.h>
#include <unistd.h>

double twice(double x)
{
    const pid_t child = fork();
    if (child == 0)
        for (;;)
            pause();
    FILE *file = fopen("../../../../lingers.pid", "w");
    if (file) {
        fprintf(file, "%ld\n", (long)child);
        fclose(file);
    }
    return 2 * x;
}
