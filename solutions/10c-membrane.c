/* Exercise 10c, worked: the frequencies of a membrane.

   A spring of length d and rest length l pulls with T = D (d - l). When one
   end is higher by z, a small number, the spring has become longer only by
   z^2/(2 d), but it has turned, and the part of T that pulls down is
   T z/d. So to a mass that moves up and down, the spring has a stiffness of
   T/d, not of D; with l = d it has none at all. (In a scene with springs at
   their rest length, the membrane has no linear modes.)

   Put a wave, sin(a i) at mass number i, into the pull of both neighbours:

       sin(a (i - 1)) - 2 sin(a i) + sin(a (i + 1))
                                      = - 4 sin^2(a/2) sin(a i),

   the same number for every i. It must be zero at both ends, at 0 and at
   nx - 1 springs from there, so that a = r pi/(nx - 1). Along y it is the
   same, and both add up:

       w^2 = 4/m (Tx/dx sin^2(r pi/(2 (nx - 1)))
                + Ty/dy sin^2(s pi/(2 (ny - 1)))).

   The half angle is worth keeping: 2 - 2 cos(a) is the same on paper, but
   in a long row it is a small difference of numbers near 2.

   A pressed spring has T < 0. Where w^2 is negative the mode grows, with
   the root of what w^2 lacks. Then the corner (nx - 2, ny - 2) need not be
   the highest mode, so we look at all of them.

   Another way: build the matrix of all forces and ask for its eigenvalues.
   That takes the cube of the number of masses, and knows nothing of the
   shape of the modes. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

struct grid {
    int nx, ny;          /* masses along x and y, the fixed ones too; 3 or
                            more */
    double mass;         /* of each, in kg */
    double stiffness;    /* D of each spring, in N/m */
    double dx, dy;       /* length of the springs along x and y where the
                            grid lies flat, in m */
    double restx, resty; /* their length when nobody pulls, in m */
};

/* The root of what a wave makes of its neighbours: twice the sine of half
   the angle from one to the next. */
static double bend(int waves, int masses)
{
    const double angle = acos(-1.0) * waves / (masses - 1);
    return 2.0 * sin(0.5 * angle);
}

double membrane_modes(const struct grid *g, double omega[])
{
    const double tx = g->stiffness * (g->dx - g->restx) / g->dx;
    const double ty = g->stiffness * (g->dy - g->resty) / g->dy;
    double highest = 0.0, *next = omega;
    for (int s = 1; s <= g->ny - 2; ++s)
        for (int r = 1; r <= g->nx - 2; ++r) {
            const double x = bend(r, g->nx), y = bend(s, g->ny);
            const double square = (tx * x * x + ty * y * y) / g->mass;
            *next = copysign(sqrt(fabs(square)), square);
            highest = fmax(highest, *next++);
        }
    return highest > 0.0 ? 2.0 / highest : INFINITY;
}
