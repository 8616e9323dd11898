/* crashed: memory without end */
/* seconds: 5 */
/* says: memory */
#include <stdlib.h>
#include <string.h>

double twice(double x)
{
    static char *volatile last;
    for (;;) {
        last = malloc(1 << 20);
        memset(last, (int)x, 1 << 20);
    }
}
