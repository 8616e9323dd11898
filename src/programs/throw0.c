/* From chapters/06-room.nw: edit there, then run make tangle. */
/* checksum 612290495 of the lines below */
/* Places four disks at random and prints the density of x, with errors. */
#include "toolbox/random.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 4, BINS = 100 };
static const double r = 0.15, L = 1; /* m */

/* Places one disk after another at random. Returns whether none overlap. */
static bool throw_all(struct random *random, double x[], double y[])
{
    for (int i = 0; i < N; ++i) {
        x[i] = random_between(random, r, L - r);
        y[i] = random_between(random, r, L - r);
        for (int j = 0; j < i; ++j) {
            const double across = x[i] - x[j], up = y[i] - y[j];
            if (across * across + up * up < 4 * r * r)
                return false;
        }
    }
    return true;
}

int main(int argc, char *argv[])
{
    const double samples = argc > 1 ? atof(argv[1]) : 1e4, unit = BINS / L;
    double sum[BINS] = {0}, squares[BINS] = {0}, x[N], y[N];
    struct random random;
    random_seed(&random, 1);
    for (double k = 0; k < samples; ++k) {
        double seen[BINS] = {0};
        while (!throw_all(&random, x, y))
            ;
        for (int i = 0; i < N; ++i)
            seen[(int)(x[i] * unit)] += unit / N;
        for (int b = 0; b < BINS; ++b)
            sum[b] += seen[b], squares[b] += seen[b] * seen[b];
    }
    for (int b = 0; b < BINS; ++b) {
        sum[b] /= samples;
        printf("%g %.9g %.3g\n", b / unit, sum[b],
               sqrt((squares[b] / samples - sum[b] * sum[b]) / samples));
    }
}
