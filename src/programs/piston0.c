/* From chapters/04-piston.nw: edit there, then run make tangle. */
/* checksum 4155763706 of the lines below */
/* Steps a piston between two gases that act as springs. */
#include "line/piston.h"

#include <stdio.h>
#include <stdlib.h>

enum { STEPS = 50 };                   /* steps between rows */
static const double every = 0.5;       /* s */
static const double energy = 10.0 / 3; /* J, of each gas at the start */

int main(int argc, char *argv[])
{
    const double start = argc == 4 ? atof(argv[1]) : 0; /* m/s */
    const double mass = argc == 4 ? atof(argv[2]) : -1; /* kg, of a gas */
    if (!(mass >= 0)) {
        fprintf(stderr, "piston0: expected VELOCITY GAS_MASS ROWS\n");
        return 2;
    }
    const struct piston p = {40, 12, {energy, 6, mass}, {energy, 6, mass}};
    struct piston_state s = {6, start * p.mass / piston_inertia(&p)};
    for (int k = 0; k <= atoi(argv[3]); ++k) {
        printf("%g %.9g %.9g %.9g\n", k * every, s.x, s.v,
               piston_energy(&p, &s));
        for (int i = 0; i < STEPS; ++i)
            if (!piston_step(&p, &s, every / STEPS))
                return 1; /* a wall was hit: the step is too long */
    }
    return 0;
}
