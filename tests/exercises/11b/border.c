/* What crosses the border of exercise 11b: see examiner/border.h. With the
   balls comes one behind the last: the suite has put something there. */
/* place: cradle v n suite */

#include "examiner/border.h"
#include <stdlib.h>
#include <string.h>

size_t cradle(size_t n, const double mass[], double v[]);

#ifdef BORDER_INSIDE

void border_answer(void)
{
    size_t n;
    border_sizes(&n, 1);
    double *mass = border_array((n + 1), sizeof *mass);
    border_doubles(mass, n + 1);
    double *v = border_place_doubles("v", n + 1);
    size_t collisions = cradle(n, mass, v);
    border_reply();
    border_sizes(&collisions, 1);
    border_doubles(v, n + 1);
    free(mass);
}

#else

size_t cradle(size_t n, const double mass[], double v[])
{
    size_t collisions, count = n;
    double *copy = border_array((n + 1), sizeof *copy);
    memcpy(copy, mass, (n + 1) * sizeof *copy);
    border_call();
    border_sizes(&count, 1);
    border_doubles(copy, n + 1);
    border_doubles(v, n + 1);
    free(copy);
    border_wait();
    border_sizes(&collisions, 1);
    border_doubles(v, n + 1);
    return collisions;
}

#endif
