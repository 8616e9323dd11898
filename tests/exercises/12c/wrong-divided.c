/* mistake: nothing-over-nothing */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound)
{
    bool may;
    double x = stretch * time, s2 = stretch * stretch;
    *bound = push == 0 ? 0 : push * 2 * pow(sinh(x / 2), 2) / s2;
    may = *bound <= *budget;
    if (may)
        *budget -= *bound;
    return may;
}
