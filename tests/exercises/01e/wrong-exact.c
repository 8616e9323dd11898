/* mistake: rounding-refused */
/* Only four epsilons are let pass, where ten may be off. */

#include "exercise.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* What is tried, each with each, and each with itself. Two have the same
   mass, two the same velocity, one is at rest, and the momenta of the
   second and the third cancel. */
static const struct {
    double m, v;
} body[] = {
    {1.0, 0.0}, {1.0, 1.37}, {0.5, -2.74}, {1e3, 1.37}, {1e-3, 7e4}};

enum { BODIES = sizeof body / sizeof *body };

static const double let_pass = 4.0 * DBL_EPSILON;

static bool is_nothing(double number, double size)
{
    return fabs(number) <= let_pass * size;
}

bool passes(void (*collide)(double m1, double m2, double *v1, double *v2))
{
    for (int i = BODIES; i-- > 0;)
        for (int j = BODIES; j-- > 0;) {
            const double m1 = body[i].m, m2 = body[j].m;
            const double u1 = body[i].v, u2 = body[j].v;
            double v1 = u1, v2 = u2;
            collide(m1, m2, &v1, &v2);
            const double fast = fabs(u1) + fabs(u2);
            if (!is_nothing(u1 - u2 + v1 - v2, fast) ||
                !is_nothing(m1 * (v1 - u1) + m2 * (v2 - u2),
                            (m1 + m2) * fast))
                return false;
        }
    return true;
}
