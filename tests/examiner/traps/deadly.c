/* crashed: the cry of a sanitizer in its copy is not what it printed */
/* says: status 3 */
#include <stdlib.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

double twice(double x)
{
    double *volatile nowhere = (double *)8;
    const pid_t child = fork();
    if (child == 0)
        *nowhere = x;
    waitpid(child, NULL, 0);
    _exit(3);
}
