/* What crosses the border of exercise 02a: see examiner/border.h. */
/* place: next_meeting left 1 */

#include "examiner/border.h"
#include <stdlib.h>

double next_meeting(size_t n, double length, const double x[],
                    const double v[], size_t *left);

#ifdef BORDER_INSIDE

void border_answer(void)
{
    size_t n;
    double length, time;
    border_sizes(&n, 1);
    border_doubles(&length, 1);
    double *x = border_array(n, sizeof x[0]);
    double *v = border_array(n, sizeof v[0]);
    border_doubles(x, n);
    border_doubles(v, n);
    size_t *left = border_place_sizes("left", 1);
    time = next_meeting(n, length, x, v, left);
    free(x);
    free(v);
    border_reply();
    border_doubles(&time, 1);
    border_sizes(left, 1);
}

#else

double next_meeting(size_t n, double length, const double x[],
                    const double v[], size_t *left)
{
    double time;
    border_call();
    border_sizes(&n, 1);
    border_doubles(&length, 1);
    border_doubles((double *)x, n);
    border_doubles((double *)v, n);
    border_sizes(left, 1);
    border_wait();
    border_doubles(&time, 1);
    border_sizes(left, 1);
    return time;
}

#endif
