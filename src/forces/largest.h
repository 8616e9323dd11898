/* The largest absolute value, or absolute difference, in arrays. */
#ifndef LARGEST_H
#define LARGEST_H

#include <math.h>
#include <stddef.h>

/* Returns the larger of two numbers, or NaN if either is NaN: a failed step
   must not look like a converged one. */
static inline double larger(double a, double b)
{
    return a >= b || a != a ? a : b;
}

/* Returns the largest |y[i]|, 0 if n is 0, or NaN if any y[i] is NaN. */
static inline double largest(const double y[], size_t n)
{
    double most = 0;
    for (size_t i = 0; i < n; ++i)
        most = larger(most, fabs(y[i]));
    return most;
}

/* Returns the largest |y[i] - z[i]|, 0 if n is 0, or NaN if any is NaN. */
static inline double largest_difference(const double y[], const double z[],
                                        size_t n)
{
    double most = 0;
    for (size_t i = 0; i < n; ++i)
        most = larger(most, fabs(y[i] - z[i]));
    return most;
}

#endif
