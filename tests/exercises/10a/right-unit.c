/* A right answer: a vector of length 1, and hypot for its length. */

#include <string.h>

double dashpot(double c, const struct body *a, const struct body *b,
               double on_a[3], double on_b[3])
{
    double n[3], r, s = 0;
    int i;
    memset(on_a, 0, 3 * sizeof(double));
    memset(on_b, 0, 3 * sizeof(double));
    memcpy(n, b->x, sizeof n);
    for (i = 0; i < 3; i++)
        n[i] -= a->x[i];
    r = hypot(hypot(n[0], n[1]), n[2]);
    if (r == 0)
        return 0;
    for (i = 0; i < 3; i++) {
        n[i] /= r;
        s += n[i] * b->v[i] - n[i] * a->v[i];
    }
    for (i = 0; i < 3; i++) {
        on_a[i] += c * s * n[i];
        on_b[i] -= c * s * n[i];
    }
    return c * s * s;
}
