/* mistake: digits-lost */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound)
{
    bool may;
    double x = stretch * time, s2 = stretch * stretch;
    *bound = push == 0 ? 0
             : x > 0   ? push * (cosh(x) - 1) / s2
                       : push * time * time / 2;
    may = *bound <= *budget;
    if (may)
        *budget -= *bound;
    return may;
}
