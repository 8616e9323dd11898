/* A right answer: complex rates for all, and a divided difference that is a
   series where the two rates come together. */

#include <complex.h>

/* (e^z - 1)/z */
static double complex mean(double complex z)
{
    double complex term = 1, sum = 1;
    int i;
    if (cabs(z) > 0.5)
        return (cexp(z) - 1) / z;
    for (i = 2; i < 20; i++)
        sum += term *= z / i;
    return sum;
}

double oscillate(const struct oscillator *o, double t, double *velocity)
{
    double b = o->damping / o->mass, k = o->stiffness / o->mass;
    double complex d = csqrt(b * b - 4 * k), slow = -2 * k / (b + d);
    double complex kick = o->v - slow * o->x;
    double complex x = cexp(slow * t) * (o->x + kick * t * mean(-d * t));
    *velocity = creal(slow * x + kick * cexp((slow - d) * t));
    return creal(x);
}
