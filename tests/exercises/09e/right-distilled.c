/* A right answer: each addition leaves its error in place of the number,
   and these are added up in the same way, four times. */

#include <stdlib.h>
#include <string.h>

static double pass(size_t n, double x[])
{
    double s = 0;
    size_t i;
    for (i = 0; i < n; i++) {
        double a = fabs(s) < fabs(x[i]) ? x[i] : s;
        double b = fabs(s) < fabs(x[i]) ? s : x[i];
        s = a + b;
        x[i] = b - (s - a);
    }
    return s;
}

double sum_up(size_t n, const double part[])
{
    double *x = malloc((n + 4) * sizeof *x), s;
    int k;
    if (n > 0)
        memcpy(x, part, n * sizeof *x);
    for (k = 0; k < 4; k++) {
        s = pass(n + k, x);
        if (isinf(s))
            break;
        x[n + k] = s;
    }
    free(x);
    return s;
}
