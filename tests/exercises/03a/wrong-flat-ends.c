/* mistake: ends-searched-for */

#include "exercise.h"
#include <stddef.h>

void equal_bins(double (*distribution)(double x), double low, double high,
                size_t bins, double edge[])
{
    size_t k;
    for (k = 0; k <= bins; k++) {
        double a = low, b = high;
        while (1) {
            double c = a / 2 + b / 2;
            if (!(a < c && c < b))
                break;
            if (distribution(c) <= (double)k / (double)bins)
                a = c;
            else
                b = c;
        }
        edge[k] = k == bins ? b : a;
    }
}
