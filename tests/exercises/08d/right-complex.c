/* The eigenvalues as complex numbers; a hundred halvings. */

#include <complex.h>

static int grows(double h)
{
    double x[2] = {1, 0}, v[2] = {0, 1};
    double complex half, root;
    step(h, x);
    step(h, v);
    half = (x[0] + v[1]) / 2;
    root = csqrt((x[0] - v[1]) * (x[0] - v[1]) / 4 + v[0] * x[1]);
    return cabs(half + root) > 1 + 1e-11 || cabs(half - root) > 1 + 1e-11;
}

double stability_limit(double most)
{
    int i = 1, k;
    double h, width = 0.005;
    while (i / 100.0 <= most && !grows(i / 100.0))
        i++;
    if (i / 100.0 > most)
        return INFINITY;
    if (i == 1)
        return 0;
    h = (i - 0.5) / 100;
    for (k = 0; k < 60; k++) {
        width /= 2;
        h += grows(h) ? -width : width;
    }
    return h;
}
