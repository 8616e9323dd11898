/* mistake: larger-newcomer */

#include "exercise.h"
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

double sum_up(size_t n, const double part[])
{
    double s = 0, c = 0;
    size_t i;
    for (i = 0; i < n; i++) {
        double y = part[i] + c, t = s + y;
        c = y - (t - s);
        s = t;
    }
    return s;
}
