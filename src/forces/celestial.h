/* Scenes from the sky: planets, two suns, choreographies, a ring. */
#ifndef CELESTIAL_H
#define CELESTIAL_H

#include "scenes/gallery.h"

#include <stddef.h>

/* The MPPhys paper's k, AU^(3/2) per day; Gauss's is 0.01720209895. */
#define CELESTIAL_K 0.0172
#define CELESTIAL_K2 2.9584e-4

/* Returns S, the sum of 1 / sqrt(1 - cos(2 pi j / count)) over j from 1 to
   count - 1: the speed of a choreography on a circle of radius R is the
   root of k2 m / R times S / 2^(3/2): (9.11, eq:choreography-speed). */
double celestial_choreography(size_t count);

/* Returns the rate at which the fastest deviation from such a choreography
   grows, in units of its angular velocity; count is 2 to 1000: (9.12,
   eq:choreography-modes). */
double celestial_growth(size_t count);

/* Returns the inward acceleration, with k2 = 1, in the plane of a flat ring
   of this mass between the radii inner and outer, at the distance r from
   its centre, not at an edge: (9.13, eq:disk-field). */
double celestial_ring_pull(double mass, double inner, double outer,
                           double r);

#endif
