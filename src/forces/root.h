/* The first root of a curve that is given by its control points. */
#ifndef ROOT_H
#define ROOT_H

#include <stddef.h>

enum {
    ROOT_DEGREE = 18,  /* of a curve, at most */
    ROOT_HALVINGS = 24 /* of the interval from 0 to 1, at most */
};

/* A curve of degree m is q[0] to q[m], its control points in the form of
   Bernstein: (11.8, eq:gap-control). */

/* Returns the first place from 0 to 1 where a curve with q[0] > 0 goes
   below 0 by more than rounding, or seems to: INFINITY if there is none. */
double root_first(const double q[], size_t m, double rounding,
                  int halvings);

/* Returns the first place after 0 where a curve with q[0] = 0 goes below 0,
   as root_first does; the curve rises from 0 with the given slope, and may
   come down again. Changes q. */
double root_next(double q[], size_t m, double slope, double rounding);

#endif
