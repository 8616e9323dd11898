/* A right answer: inverse masses, and a vector of length 1. */

#include <string.h>

double part_spheres(struct sphere *a, struct sphere *b)
{
    double n[3] = {1, 0, 0}, d[3], r, h, wa = 1 / a->mass, wb = 1 / b->mass;
    double top = fmax(wa, wb), sum;
    int i;
    memcpy(d, a->x, sizeof d);
    for (i = 0; i < 3; i++)
        d[i] -= b->x[i];
    r = sqrt(d[2] * d[2] + d[1] * d[1] + d[0] * d[0]);
    if (r >= a->radius + b->radius)
        return 0;
    h = a->radius - r + b->radius;
    for (i = 0; i < 3; i++)
        if (r > 0)
            n[i] = -d[i] / r;
    wa /= top;
    wb /= top;
    sum = wa + wb;
    for (i = 0; i < 3; i++) {
        if (wa > 0)
            a->x[i] -= n[i] * h * wa / sum;
        if (wb > 0)
            b->x[i] += n[i] * h * wb / sum;
    }
    return h;
}
