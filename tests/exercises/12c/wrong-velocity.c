/* mistake: velocity-for-place */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound)
{
    bool may;
    double x = stretch * time;
    *bound = push == 0 ? 0 : x > 0 ? push * sinh(x) / stretch : push * time;
    may = *bound <= *budget;
    if (may)
        *budget -= *bound;
    return may;
}
