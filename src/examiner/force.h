/* Forces between bodies, for students' programs. */
#ifndef EXAMINER_FORCE_H
#define EXAMINER_FORCE_H

#ifdef EXAMINER_GIVES
void force(int n, const double m[], const double x[], double f[]);
#else
#include <math.h>

/* Sets f to the forces [N] on n bodies with masses m [kg] at positions x
   [m]. Body i is at (x[2 i], x[2 i + 1]) and feels the force (f[2 i], f[2 i
   + 1]). Two bodies at distance d attract each other with the force m1
   m2/d^2, as if G were 1. */
static inline void force(int n, const double m[], const double x[],
                         double f[])
{
    for (int i = 0; i < n; ++i) {
        f[2 * i] = f[2 * i + 1] = 0.0;
        for (int j = 0; j < n; ++j) {
            const double dx = x[2 * j] - x[2 * i];
            const double dy = x[2 * j + 1] - x[2 * i + 1];
            const double d = hypot(dx, dy);
            if (j == i)
                continue;
            f[2 * i] += m[i] * m[j] * dx / (d * d * d);
            f[2 * i + 1] += m[i] * m[j] * dy / (d * d * d);
        }
    }
}
#endif

#endif
