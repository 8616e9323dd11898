/* Computes the motion of a piston between two gases that act as springs. */
#ifndef PISTON_H
#define PISTON_H

#include <stdbool.h>
#include <stddef.h>

/* A gas on a line between a wall and the piston, compressed so slowly that
   its kinetic energy depends only on its length. */
struct piston_gas {
    double energy; /* kinetic energy at `length`, J, not negative */
    double length; /* m, positive */
    double mass;   /* kg, may be 0; a third of it adds to the piston's
                      inertia */
};

/* A piston between two gases in a box with walls at 0 and length. */
struct piston {
    double mass;   /* kg, positive */
    double length; /* m, positive */
    struct piston_gas left, right;
};

struct piston_state {
    double x, v; /* position from the left wall, m; velocity, m/s */
};

/* Returns the kinetic energy (J) of a gas after slow compression or
   expansion to a positive length (m). Source: (4.1, eq:adiabat). */
double piston_gas_energy(const struct piston_gas *gas, double length);

/* Return the energy (J) stored in the two gases, and their force (N) on
   the piston, positive to the right. Require 0 < x < p->length. Source:
   (4.4, eq:piston-energy), (4.2, eq:piston-force). */
double piston_potential(const struct piston *p, double x);
double piston_force(const struct piston *p, double x);

/* Returns the effective moving mass (kg): the mass of the piston and a
   third of the mass of each gas. Source: (4.10, eq:added-mass). */
double piston_inertia(const struct piston *p);

/* Advances the piston by a leapfrog step of dt (s), which may be negative.
   Returns false and changes nothing if the step leads into a wall. Uses
   only + - * /. Source: (4.5, eq:leapfrog). */
bool piston_step(const struct piston *p, struct piston_state *s, double dt);

/* Like piston_step, but with a classical fourth-order Runge-Kutta step, for
   comparison. */
bool piston_step_rk4(const struct piston *p, struct piston_state *s,
                     double dt);

/* Returns the energy (J) of the effective moving mass and the two gases. */
double piston_energy(const struct piston *p, const struct piston_state *s);

/* Returns the position (m), inside the box, at which the forces of the two
   gases balance. Requires positive energies of both gases. Source: (4.6,
   eq:piston-rest). */
double piston_rest(const struct piston *p);

/* Returns the angular frequency (1/s) of small oscillations about the
   equilibrium position. Source: (4.7, eq:piston-small), with M from
   piston_inertia. */
double piston_frequency(const struct piston *p);

/* Sets *low and *high to the positions (m) at which the piston turns round.
   Returns false, with nothing changed, if the energy (J) is below the
   potential at rest. Requires positive energies of both gases. */
bool piston_turning_points(const struct piston *p, double energy,
                           double *low, double *high);

/* Returns the period (s) of an oscillation with the given energy (J),
   integrated numerically with the given number of points. 16 points give 12
   digits if no gas is compressed below a third of its length. Returns NAN
   if there are no points or no turning points. Source: (4.8,
   eq:piston-large), with the substitution (4.9, eq:piston-circle). */
double piston_period(const struct piston *p, double energy, size_t points);

/* Returns the lowest angular frequency (1/s) of small oscillations of the
   piston coupled to sound waves in the gases. For massless gases it equals
   piston_frequency. Requires positive energies of both gases. Source:
   (4.11, eq:acoustic). */
double piston_frequency_acoustic(const struct piston *p);

#endif
