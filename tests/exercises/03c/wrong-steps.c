/* mistake: digits-lost */

#include "exercise.h"
#include <math.h>

double velocity_below(int n, double u)
{
    double part = 0, all = 0, p, s;
    int i, steps = 20000;
    if (u <= -1)
        return 0;
    if (u >= 1)
        return 1;
    for (i = 0; i < steps; i++) {
        s = -1 + (u + 1) * (i + 0.5) / steps;
        part += pow(1 - s * s, (n - 3) / 2.0);
    }
    p = (u + 1) * part;
    for (i = 0; i < steps; i++) {
        s = -1 + 2 * (i + 0.5) / steps;
        all += pow(1 - s * s, (n - 3) / 2.0);
    }
    return p / (2 * all);
}
