/* The first root of a curve given by its control points. */
#ifndef ROOT_H
#define ROOT_H

#include <stddef.h>

enum {
    ROOT_DEGREE = 18,  /* largest degree of a curve */
    ROOT_HALVINGS = 24 /* maximum number of halvings of the interval */
};

/* A curve of degree m is given by q[0] to q[m], its control points in
   Bernstein's form: (11.8, eq:gap-control). */

/* Returns the first time from 0 to 1 at which a curve with q[0] > 0 is
   below 0 by more than rounding, or INFINITY if there is none. The interval
   is halved up to `halvings` times. If the curve may still be below 0 in
   the last interval, the middle of that interval is returned. */
double root_first(const double q[], size_t m, double rounding,
                  int halvings);

/* Returns the first time after 0 at which a curve with q[0] = 0 goes below
   0, in the sense of root_first. The curve rises from 0 with the slope
   `slope`, and may come down again. Changes q. */
double root_next(double q[], size_t m, double slope, double rounding);

#endif
