/* mistake: one-after-another */

#include <stdlib.h>
#include <string.h>

double sum_up(size_t n, const double part[])
{
    double s = 0;
    size_t i;
    for (i = 0; i < n; i++)
        s += part[i];
    return s;
}
