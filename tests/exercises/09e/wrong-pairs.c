/* mistake: in-pairs */

#include "exercise.h"
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

double sum_up(size_t n, const double part[])
{
    if (n == 0)
        return 0;
    if (n == 1)
        return part[0];
    return sum_up(n / 2, part) + sum_up(n - n / 2, part + n / 2);
}
