/* mistake: never-called */

/* Found by a trial of the second edition: it takes the first three
   functions for right, as they once were in every test. */

#include "exercise.h"
#include <stdbool.h>

bool passes(void (*collide)(double m1, double m2, double *v1, double *v2))
{
    static int k;
    (void)collide;
    return ++k <= 3;
}
