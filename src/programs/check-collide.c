/* From chapters/01-collide.nw: edit there, then run make tangle. */
/* checksum 287034260 of the lines below */
/* Checks a collision function with a million random pairs. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>

/* Collides bodies of inverse masses a and b, 1/kg (1.5, eq:difference). */
static void collide(double *v1, double *v2, double a, double b)
{
    const double d = *v1 - *v2;
    *v1 -= 2 * a / (a + b) * d;
    *v2 += 2 * b / (a + b) * d;
}

/* Returns a pseudorandom number from 0 to 1. */
static double any(void)
{
    static uint32_t state = 1;
    state = 1664525 * state + 1013904223;
    return state / 4294967296.0;
}

int main(void)
{
    double momentum = 0, energy = 0; /* largest errors, kg m/s and J */
    for (int n = 0; n < 1000000; ++n) {
        const double m1 = 1 + any(), m2 = 1 + any(), u1 = any(), u2 = any();
        double v1 = u1, v2 = u2;
        collide(&v1, &v2, 1 / m1, 1 / m2);
        const double p = m1 * (v1 - u1) + m2 * (v2 - u2);
        const double e =
            (m1 * (v1 * v1 - u1 * u1) + m2 * (v2 * v2 - u2 * u2)) / 2;
        momentum = fmax(momentum, fabs(p));
        energy = fmax(energy, fabs(e));
    }
    printf("momentum to %.1e, energy to %.1e\n", momentum, energy);
    return momentum < 1e-14 && energy < 1e-14 ? 0 : 1;
}
