/* mistake: stretch-forgotten */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound)
{
    bool may;
    (void)stretch;
    *bound = push == 0 ? 0 : push * time * time / 2;
    may = *bound <= *budget;
    if (may)
        *budget -= *bound;
    return may;
}
