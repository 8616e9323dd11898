/* crashed: one double further than malloc gave; the line is told */
/* needs: sanitizers */
/* says: past the end of memory that malloc */
/* says: heap.c:12, in the function twice */
/* says: | .*row.i. = x */
#include <stdlib.h>

double twice(double x)
{
    const volatile int i = 3;
    double *row = malloc(3 * sizeof *row);
    row[i] = x;
    x += row[i];
    free(row);
    return x;
}
