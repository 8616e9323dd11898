/* mistake: digits-lost */

#include "exercise.h"
#include <math.h>

double velocity_below(int n, double u)
{
    double k = (n - 3) / 2.0, t = 1, sum = 0, all = 0;
    int i;
    if (u <= -1)
        return 0;
    if (u >= 1)
        return 1;
    if (n == 2)
        return 0.5 + asin(u) / acos(-1);
    for (i = 0; i < 400; i++) {
        sum += t * pow(u, 2 * i + 1) / (2 * i + 1);
        t *= -(k - i) / (i + 1);
    }
    all = sqrt(acos(-1)) * tgamma(k + 1) / tgamma(k + 1.5);
    return 0.5 + sum / all;
}
