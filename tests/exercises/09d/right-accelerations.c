/* A right answer: accelerations in an array of their own, and the three
   parts of the step in a loop. */

#include <stdlib.h>

void ellipses_and_kicks(size_t n, const double gm[], double sun, double dt,
                        double x[][3], double v[][3])
{
    double *acc = malloc(3 * n * sizeof *acc);
    int part;
    for (part = 0; part < 3; part++) {
        size_t i, j;
        if (part == 1) {
            for (i = 0; i < n; i++)
                drift(sun, dt, x[i], v[i]);
            continue;
        }
        for (i = 0; i < 3 * n; i++)
            acc[i] = 0;
        for (i = 0; i < n; i++)
            for (j = 0; j < n; j++) {
                double q = 0;
                int k;
                for (k = 0; k < 3; k++)
                    q += pow(x[j][k] - x[i][k], 2);
                for (k = 0; k < 3 && i != j; k++)
                    acc[3 * i + k] +=
                        gm[j] * pow(q, -1.5) * (x[j][k] - x[i][k]);
            }
        for (i = 0; i < 3 * n; i++)
            v[i / 3][i % 3] += dt / 2 * acc[i];
    }
    free(acc);
}
