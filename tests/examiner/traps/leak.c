/* passed: memory that nobody gives back */
/* needs: sanitizers */
/* says: advice, which costs no point */
/* says: lost it without free */
/* says: leak.c:15, in the function twice */
/* says: double .lost = malloc */
#include <stdlib.h>

double twice(double x);

double twice(double x)
{
    double sum;
    /* nobody keeps it */
    double *lost = malloc(sizeof *lost);
    *lost = x + x;
    sum = *lost;
    return sum;
}
