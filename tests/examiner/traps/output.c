/* crashed: output without end */
/* says: printed or wrote more than 1 MiB */
/* says: | and on and on */
#include <stdio.h>

double twice(double x)
{
    for (;;)
        puts("and on and on");
    return 2 * x;
}
