/* mistake: just-the-budget */
/* The bound is compared with what is left of the budget. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound)
{
    const double u = 0.5 * stretch * time;
    const double more = u > 0.0 ? sinh(u) / u : 1.0;
    *bound = push > 0.0 ? 0.5 * push * time * time * more * more : 0.0;
    if (*bound <= *budget)
        *budget -= *bound;
    return *bound <= *budget;
}
