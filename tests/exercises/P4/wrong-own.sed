# mistake: own-force, stage 1, given 0 1 2 3
# Its own law, whatever the header says.
s/^#include "force.h"$//
s/^static void ask(struct run \*r)$/static void force(int n, const double m[], const double x[], double f[])\
{\
    for (int i = 0; i < n; ++i) {\
        f[2 * i] = f[2 * i + 1] = 0;\
        for (int j = 0; j < n; ++j) {\
            const double dx = x[2 * j] - x[2 * i], dy = x[2 * j + 1] - x[2 * i + 1];\
            const double d = hypot(dx, dy) + (i == j);\
            f[2 * i] += m[i] * m[j] * dx \/ (d * d * d);\
            f[2 * i + 1] += m[i] * m[j] * dy \/ (d * d * d);\
        }\
    }\
}\
\
&/
