/* What crosses the border of exercise 09e: see examiner/border.h. */
/* place: none */

#include "examiner/border.h"
#include <stdlib.h>

double sum_up(size_t n, const double part[]);

#ifdef BORDER_INSIDE

void border_answer(void)
{
    size_t n;
    border_sizes(&n, 1);
    double *part = border_array(n, sizeof *part);
    border_doubles(part, n);
    double sum = sum_up(n, part);
    border_reply();
    border_doubles(&sum, 1);
    free(part);
}

#else

double sum_up(size_t n, const double part[])
{
    double sum;
    border_call();
    border_sizes(&n, 1);
    border_doubles((double *)part, n); /* which only reads on this side */
    border_wait();
    border_doubles(&sum, 1);
    return sum;
}

#endif
