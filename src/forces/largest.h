/* From chapters/works/08-stepping.nw: edit there, then run make tangle. */
/* checksum 3991642906 of the lines below */
/* The largest of many moduli. */
#ifndef LARGEST_H
#define LARGEST_H

#include <math.h>
#include <stddef.h>

/* The larger one; not a number if one of them is not. */
static inline double larger(double a, double b)
{
    return a >= b || a != a ? a : b;
}

/* The largest of n moduli, 0 for none; not a number if one of them is
   not. */
static inline double largest(const double y[], size_t n)
{
    double most = 0;
    for (size_t i = 0; i < n; ++i)
        most = larger(most, fabs(y[i]));
    return most;
}

/* The largest modulus of y[i] - z[i], likewise. */
static inline double largest_difference(const double y[], const double z[],
                                        size_t n)
{
    double most = 0;
    for (size_t i = 0; i < n; ++i)
        most = larger(most, fabs(y[i] - z[i]));
    return most;
}

#endif
