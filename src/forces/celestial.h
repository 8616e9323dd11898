/* From chapters/works/09-gravity.nw: edit there, then run make tangle. */
/* checksum 1321180975 of the lines below */
/* Scenes of the sky: planets, two suns, choreographies, a ring. */
#ifndef CELESTIAL_H
#define CELESTIAL_H

#include "scenes/gallery.h"

#include <stddef.h>

/* The paper's k, AU^(3/2) per day; Gauss's is 0.01720209895. */
#define CELESTIAL_K 0.0172
#define CELESTIAL_K2 2.9584e-4

/* The sum of 1 / sqrt(1 - cos(2 pi j / count)), j = 1 .. count - 1: the
   squared speed of a choreography on a circle of radius R is k2 m / R
   times it, over 2^(3/2). Source: (9.11, eq:choreography-speed). */
double celestial_choreography(size_t count);

/* The rate at which the fastest deviation of such a choreography grows, in
   units of its angular velocity; count 2 to 1000. Source: (9.12,
   eq:choreography-modes). */
double celestial_growth(size_t count);

/* The inward acceleration at the distance r from the middle of a flat
   ring of this mass between the radii inner and outer, in its plane, with
   k2 = 1; r not at an edge. Source: (9.13, eq:disk-field). */
double celestial_ring_pull(double mass, double inner, double outer,
                           double r);

#endif
