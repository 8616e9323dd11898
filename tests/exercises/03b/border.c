/* What crosses the border of exercise 03b: see examiner/border.h. */
/* place: mean_and_error error 1 */

#include "examiner/border.h"
#include <stdlib.h>

double mean_and_error(size_t n, const double x[], double *error);

#ifdef BORDER_INSIDE

void border_answer(void)
{
    size_t n;
    border_sizes(&n, 1);
    double *x = border_array(n, sizeof *x);
    border_doubles(x, n);
    double *error = border_place_doubles("error", 1);
    double mean = mean_and_error(n, x, error);
    border_reply();
    border_doubles(&mean, 1);
    border_doubles(error, 1);
    free(x);
}

#else

double mean_and_error(size_t n, const double x[], double *error)
{
    double mean;
    border_call();
    border_sizes(&n, 1);
    border_doubles((double *)x, n); /* which only reads on this side */
    border_doubles(error, 1);
    border_wait();
    border_doubles(&mean, 1);
    border_doubles(error, 1);
    return mean;
}

#endif
