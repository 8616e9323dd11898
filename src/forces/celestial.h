/* Celestial scenes: planets, a binary star, choreographies, a ring. */
#ifndef CELESTIAL_H
#define CELESTIAL_H

#include "scenes/gallery.h"

#include <stddef.h>

/* The constant k of the MPPhys paper, AU^(3/2) per day, and its square.
   Gauss's value of k is 0.01720209895. */
#define CELESTIAL_K 0.0172
#define CELESTIAL_K2 2.9584e-4

/* Returns S, the sum of 1 / sqrt(1 - cos(2 pi j / count)) over j from 1 to
   count - 1. The speed of a choreography on a circle of radius R is the
   square root of k2 m S / (2^(3/2) R): (9.11, eq:choreography-speed). */
double celestial_choreography(size_t count);

/* Returns the growth rate of the fastest-growing deviation from a
   choreography of 2 to 1000 bodies, in units of their angular velocity:
   (9.12, eq:choreography-modes). */
double celestial_growth(size_t count);

/* Returns the inward acceleration, with k2 = 1, due to a flat ring of this
   mass between the radii inner and outer: (9.13, eq:disk-field). The field
   point is in the plane of the ring, at the distance r from its centre. r
   must differ from inner and outer. */
double celestial_ring_pull(double mass, double inner, double outer,
                           double r);

#endif
