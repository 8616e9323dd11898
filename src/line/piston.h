/* A piston between two gases that act as springs. */
#ifndef PISTON_H
#define PISTON_H

#include <stdbool.h>
#include <stddef.h>

/* A gas on a line between a wall and the piston, compressed slowly. */
struct piston_gas {
    double energy; /* its kinetic energy (J), not negative, ... */
    double length; /* ... when it is so long (m), positive */
    double mass;   /* kg; a third of it is added to the inertia of the
                      piston; may be 0 */
};

/* A piston between two gases in a box with walls at 0 and length. */
struct piston {
    double mass;   /* kg, positive */
    double length; /* m, positive */
    struct piston_gas left, right;
};

struct piston_state {
    double x, v; /* m from the left wall, m/s */
};

/* Returns the kinetic energy (J) of a gas compressed or expanded slowly
   to this length (m), positive. Source: (4.1, eq:adiabat). */
double piston_gas_energy(const struct piston_gas *gas, double length);

/* Return the energy (J) stored in the two gases, and their force (N) on
   the piston, positive to the right. Require 0 < x < p->length. Source:
   (4.4, eq:piston-energy), (4.2, eq:piston-force). */
double piston_potential(const struct piston *p, double x);
double piston_force(const struct piston *p, double x);

/* Returns the mass (kg) that is set in motion: the piston's, and a third
   of each gas's. Source: (4.10, eq:added-mass). */
double piston_inertia(const struct piston *p);

/* Moves the piston by one leapfrog step dt (s), of either sign. Returns
   true, or false with nothing changed when the step leads into a wall:
   it was too long. Only + - * / are used. Source: (4.5, eq:leapfrog). */
bool piston_step(const struct piston *p, struct piston_state *s, double dt);

/* Moves the piston as piston_step does, but by a classical fourth-order
   Runge-Kutta step, for comparison. */
bool piston_step_rk4(const struct piston *p, struct piston_state *s,
                     double dt);

/* Returns the energy (J) of the moving mass and the two gases. */
double piston_energy(const struct piston *p, const struct piston_state *s);

/* Returns where (m) the two gases balance, strictly inside the box.
   Requires both energies positive. Source: (4.6, eq:piston-rest). */
double piston_rest(const struct piston *p);

/* Returns the angular frequency (1/s) of very small swings about it.
   Source: (4.7, eq:piston-small) with piston_inertia for M. */
double piston_frequency(const struct piston *p);

/* Sets *low and *high to where (m) the piston turns back. Returns false
   with nothing changed when the energy (J) is below the potential at
   rest. Requires both gases' energies positive. */
bool piston_turning_points(const struct piston *p, double energy,
                           double *low, double *high);

/* Returns the period (s) of a swing of this energy (J), from the values
   of its integrand at this many points: 16 give 12 digits if the gases are
   not squeezed below a third. NAN without points or turning points.
   Source: (4.8, eq:piston-large), by the substitution (4.9,
   eq:piston-circle). */
double piston_period(const struct piston *p, double energy, size_t points);

/* Returns the lowest angular frequency (1/s) of small swings when sound
   takes its time through the gases, whose masses (kg) are then counted in
   full. Without gas masses it is piston_frequency. Requires both energies
   positive. Source: (4.11, eq:acoustic). */
double piston_frequency_acoustic(const struct piston *p);

#endif
