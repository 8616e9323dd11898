/* mistake: between-0-and-1 */

#include "exercise.h"
#include <stddef.h>

static double search(double (*f)(double x), double a, double b,
                     double target)
{
    int i;
    for (i = 0; i < 100; i++) {
        double c = (a + b) / 2;
        if (f(c) < target)
            a = c;
        else
            b = c;
    }
    return (a + b) / 2;
}

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[])
{
    size_t k;
    edge[0] = low;
    edge[bins] = high;
    for (k = 1; k < bins; k++)
        edge[k] = search(distribution, 0, 1, (double)k / (double)bins);
}
