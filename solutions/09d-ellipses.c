/* Exercise 09d, worked: ellipses, and kicks from the others.

   The Sun's pull is a thousand times that of a planet, and the drift knows
   it exactly. So it must not stand in a kick, or it would be counted twice.
   What is left for the kicks are the pairs of planets. Each pair is gone
   through once, and each of the two gets the other's gm; the arrow between
   them has the length r, so the third power of r is divided by.

   Half a kick first and half a kick last, from the places where the planets
   are then: read backwards, with -dt, the step is its own undoing. So its
   error has no odd powers of dt in it, and is of the second order; and as
   every part of it contains a planet's mass, it is a thousand times smaller
   than that of a leapfrog.

   The last half kick of a step and the first of the next one are from the
   same places: a program that goes on computes them once.

   In the book the Sun moves, too, and Jacobi's coordinates are needed. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

void drift(double sun, double dt, double x[3], double v[3]);

static void disturb(size_t n, const double gm[], double half, double x[][3],
                    double v[][3])
{
    for (size_t i = 1; i < n; ++i)
        for (size_t j = i; j-- > 0;) {
            const double d[] = {x[j][0] - x[i][0], x[j][1] - x[i][1],
                                x[j][2] - x[i][2]};
            const double r = hypot(hypot(d[0], d[1]), d[2]);
            for (int k = 0; k < 3; ++k) {
                v[i][k] += half * gm[j] * d[k] / pow(r, 3.0);
                v[j][k] -= half * gm[i] * d[k] / pow(r, 3.0);
            }
        }
}

void ellipses_and_kicks(size_t n, const double gm[], double sun, double dt,
                        double x[][3], double v[][3])
{
    disturb(n, gm, 0.5 * dt, x, v);
    for (size_t i = n; i-- > 0;)
        drift(sun, dt, x[i], v[i]);
    disturb(n, gm, 0.5 * dt, x, v);
}
