/* Exercise 04b. A decay time from noisy shares (stretch, 35 minutes)

   A heavy piston loses its energy: its share falls towards what belongs to
   it in the end, and what is too much, share - limit, falls as
   exp(-t / tau). Many runs were averaged, so each share has a standard
   error. How large is tau, and how well is it known?

   Given:
     n        how many points, in any order of time
     t        t[0] to t[n - 1], their times, in s
     share    the shares measured
     error    their standard errors, each greater than zero
     limit    what the share falls to
   To fill in:
     *tau     the decay time, in s
     *sigma   its standard error, in s, from the errors given
   Fit a straight line in t to the logarithm of y = share - limit by
   weighted least squares, with 1 / (standard error of the LOGARITHM)^2 for
   the weight, which is (y / error)^2; intercept and slope are both unknown.
   Leave out each point, wherever it stands, whose y is not greater than
   3 errors.
   Returns false, and what is filled in does not matter, when the points
   left have fewer than two different times, or when their line does not
   fall; otherwise true.

   Check your answer with    make check EX=04b
   Hints, which ask before they tell:    make hint EX=04b */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool decay_time(size_t n, const double t[], const double share[],
                const double error[], double limit, double *tau,
                double *sigma)
{
    /* TODO: replace these lines by your own. Which sums over the points
       give the slope of a weighted line, which its error, and what do the
       two have to do with tau? */
    (void)n;
    (void)share;
    (void)error;
    (void)limit;
    *tau = NOT_DONE_YET(t[0]);
    *sigma = NOT_DONE_YET(0.0);
    return true;
}
