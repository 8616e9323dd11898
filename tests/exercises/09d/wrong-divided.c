/* mistake: divided-by-own-mass */
/* The force first, and then the acceleration: 0/0 for a body without mass.
 */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

void drift(double sun, double dt, double x[3], double v[3]);

static void pulls(size_t n, const double gm[], double t, double x[][3],
                  double v[][3])
{
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            double s = 0;
            for (int k = 0; k < 3; k++)
                s += pow(x[i][k] - x[j][k], 2);
            for (int k = 0; k < 3 && i != j; k++) {
                double force =
                    gm[i] * gm[j] * (x[j][k] - x[i][k]) * pow(s, -1.5);
                v[i][k] += t * force / gm[i];
            }
        }
}

void ellipses_and_kicks(size_t n, const double gm[], double sun, double dt,
                        double x[][3], double v[][3])
{
    pulls(n, gm, dt / 2, x, v);
    for (size_t i = 0; i < n; i++)
        drift(sun, dt, x[i], v[i]);
    pulls(n, gm, dt / 2, x, v);
}
