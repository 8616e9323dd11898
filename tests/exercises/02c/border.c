/* What crosses the border of exercise 02c: see examiner/border.h. */
/* place: positions_at x n */
/* place: positions_at v n */

#include "examiner/border.h"
#include <stdlib.h>

void positions_at(size_t n, double length, const double x0[],
                  const double v0[], double t, double x[], double v[]);

#ifdef BORDER_INSIDE

static double *taken(size_t n)
{
    double *numbers = border_array(n, sizeof numbers[0]);
    border_doubles(numbers, n);
    return numbers;
}

void border_answer(void)
{
    size_t n;
    double length, t;
    border_sizes(&n, 1);
    border_doubles(&length, 1);
    border_doubles(&t, 1);
    double *x0 = taken(n), *v0 = taken(n);
    double *x = border_place_doubles("x", n);
    double *v = border_place_doubles("v", n);
    positions_at(n, length, x0, v0, t, x, v);
    free(x0);
    free(v0);
    border_reply();
    border_doubles(x, n);
    border_doubles(v, n);
}

#else

void positions_at(size_t n, double length, const double x0[],
                  const double v0[], double t, double x[], double v[])
{
    border_call();
    border_sizes(&n, 1);
    border_doubles(&length, 1);
    border_doubles(&t, 1);
    border_doubles((double *)x0, n);
    border_doubles((double *)v0, n);
    border_doubles(x, n);
    border_doubles(v, n);
    border_wait();
    border_doubles(x, n);
    border_doubles(v, n);
}

#endif
