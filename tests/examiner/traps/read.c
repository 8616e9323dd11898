/* passed: there is nothing to read, so that it cannot wait for it */
#include <stdio.h>

double twice(double x)
{
    while (getchar() != EOF)
        ;
    return 2 * x;
}
