/* The speed distributions of a gas: that of N disks, and Maxwell's. */
#ifndef SPEEDS_H
#define SPEEDS_H

#include <stdbool.h>
#include <stddef.h>

/* The distribution of u = v sqrt(m / (2 kT)), with v a speed or the modulus
   of one of its components: density u^rise (1 - u^2 / most)^(halves / 2),
   or Maxwell's, u^rise exp(-u^2), if most = 0, times a constant. */
struct speeds_law {
    size_t rise, halves;
    double most;
};

/* Returns the exact law (7.3, eq:speed-law) for one of `disks` disks in 2
   or 3 dimensions: of its speed, or of a component. resting: the total
   momentum is zero, as in a periodic box, and the masses are equal.
   Requires 2 disks, 3 if resting. */
struct speeds_law speeds_exact(size_t dimensions, size_t disks,
                               bool resting, bool component);

/* Returns the law for infinitely many disks (7.4, eq:maxwell-2d). */
struct speeds_law speeds_maxwell(size_t dimensions, bool component);

/* Fills density[bins] with the law's means over bins of this width from 0
   on, and returns the mean of u; both are identical on every machine. Both
   are within 1e-9 for at least 6 disks and bins of 0.1 that reach to 4.
   (For 2 or 3 disks the law may end abruptly, and the density of its last
   bin be wrong by 2e-2.) */
double speeds_bins(const struct speeds_law *l, double width, size_t bins,
                   double density[]);

/* Returns the mean of u^4 of a speed under this law. */
double speeds_fourth(const struct speeds_law *l);

#endif
