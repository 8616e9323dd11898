/* 01e failed: takes the first three for right, and calls none of them */
/* Found by a trial of the second edition. */
#include "exercise.h"
#include <stdbool.h>
bool passes(void (*collide)(double m1, double m2, double *v1, double *v2))
{
    static int k;
    (void)collide;
    return ++k <= 3;
}
