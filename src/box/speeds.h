/* The laws of the speeds in a gas: that of N disks, and Maxwell's. */
#ifndef SPEEDS_H
#define SPEEDS_H

#include <stdbool.h>
#include <stddef.h>

/* The law of u = v sqrt(m / (2 kT)), of a speed or of the modulus of one
   component, v: density u^rise (1 - u^2 / most)^(halves / 2), or with
   most = 0 Maxwell's, u^rise exp(-u^2), times a constant. */
struct speeds_law {
    size_t rise, halves;
    double most;
};

/* The exact law (7.3, eq:speed-law) of one of so many disks in 2 or 3
   dimensions: of its speed, or of a component. resting: the total momentum
   is zero, as in a periodic box, and the masses are equal. Requires 2
   disks, 3 if resting. */
struct speeds_law speeds_exact(size_t dimensions, size_t disks,
                               bool resting, bool component);

/* The law of infinitely many (7.4, eq:maxwell-2d). */
struct speeds_law speeds_maxwell(size_t dimensions, bool component);

/* Fills density[bins] with the law's means over bins of this width from 0
   on, and returns the mean of u, both within 1e-9 for bins of 0.1 that
   reach to 4 and 6 disks or more. (Of 2 or 3 the law may end abruptly, and
   the bin in which it does be off by 2e-2.) The same bits on every machine.
   */
double speeds_bins(const struct speeds_law *l, double width, size_t bins,
                   double density[]);

/* The mean of u^4 of a speed under this law. */
double speeds_fourth(const struct speeds_law *l);

#endif
