/* The largest of many moduli. */
#ifndef LARGEST_H
#define LARGEST_H

#include <math.h>
#include <stddef.h>

/* Returns the larger one, NaN if one of them is: a step that went wrong
   must not look like one that has converged. */
static inline double larger(double a, double b)
{
    return a >= b || a != a ? a : b;
}

/* Returns the largest of n moduli, 0 for none, NaN if one of them is. */
static inline double largest(const double y[], size_t n)
{
    double most = 0;
    for (size_t i = 0; i < n; ++i)
        most = larger(most, fabs(y[i]));
    return most;
}

/* Returns the largest modulus of y[i] - z[i], likewise. */
static inline double largest_difference(const double y[], const double z[],
                                        size_t n)
{
    double most = 0;
    for (size_t i = 0; i < n; ++i)
        most = larger(most, fabs(y[i] - z[i]));
    return most;
}

#endif
