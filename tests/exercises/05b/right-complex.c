/* A right answer: places and velocities as complex numbers. */

#include <complex.h>

double falling_pair_time(double g, const struct thrown *a,
                         const struct thrown *b, double *height)
{
    double complex d = (b->x - a->x) + (b->y - a->y) * I;
    double complex u = (b->vx - a->vx) + (b->vy - a->vy) * I;
    double s = a->radius + b->radius, t;
    double product = creal(conj(d) * u);
    double under = product * product;
    double gap = creal(conj(d) * d) - s * s;
    under -= creal(conj(u) * u) * gap;
    if (product >= 0 || under < 0)
        return INFINITY;
    t = gap > 0 ? gap / (sqrt(under) - product) : 0;
    d += u * t;
    *height = a->y + a->vy * t - g / 2 * t * t + cimag(d) / s * a->radius;
    return t;
}
