/* Computes the speed distribution of N disks, and Maxwell's. */
#ifndef SPEEDS_H
#define SPEEDS_H

#include <stdbool.h>
#include <stddef.h>

/* The distribution of u = v sqrt(m / (2 kT)), where v is a speed or the
   magnitude of a velocity component. The density is a constant times u^rise
   (1 - u^2 / most)^(halves / 2) or, if most = 0, times Maxwell's u^rise
   exp(-u^2). */
struct speeds_law {
    size_t rise, halves;
    double most;
};

/* Returns the exact law (7.3, eq:speed-law) of the speed, or of a velocity
   component, of one of `disks` disks in 2 or 3 dimensions. `resting` means
   that the total momentum is zero, as in a periodic box, and that the
   masses are equal. Requires at least 2 disks, or 3 if resting. */
struct speeds_law speeds_exact(size_t dimensions, size_t disks,
                               bool resting, bool component);

/* Returns the law for infinitely many disks (7.4, eq:maxwell-2d). */
struct speeds_law speeds_maxwell(size_t dimensions, bool component);

/* Fills density[bins] with the means of the law over bins of this width,
   beginning at 0. Returns the mean of u. The results are identical on every
   machine. Their error is less than 1e-9 for at least 6 disks and bins of
   0.1 that reach to 4. (For 2 or 3 disks the law may end abruptly, and the
   density of its last bin may be wrong by 2e-2.) */
double speeds_bins(const struct speeds_law *l, double width, size_t bins,
                   double density[]);

/* Returns the mean of u^4, where the speed u is distributed by this law. */
double speeds_fourth(const struct speeds_law *l);

#endif
