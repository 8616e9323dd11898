/* mistake: digits-lost */
/* pi to eight digits. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

double velocity_below(int n, double u)
{
    if (fabs(u) >= 1.0)
        return u < 0.0 ? 0.0 : 1.0;
    const double pi = 3.1415927;
    const double rest = (1.0 - u) * (1.0 + u);
    const bool even = n % 2 == 0;
    double below = 0.5 + (even ? asin(u) / pi : 0.5 * u);
    double term = even ? u * sqrt(rest) / pi : 0.25 * u * rest;
    for (int k = even ? 4 : 5; k <= n; k += 2) {
        below += term;
        term *= rest * (k - 2) / (k - 1);
    }
    return below;
}
