/* Exercise 03b. An error bar that keeps its word (core, 30 minutes)

   An error bar is a promise: the true value is less than one standard error
   away in 68 of 100 cases, and less than two in 95. Here is one series of
   numbers. What is their mean, and how wrong may it be?

   Given:
     n       how many values, 6000 or more
     x       x[0] to x[n - 1], in the order in which they were measured. The
             series has a memory, and you are not told which: none, a short
             one, a long one, two at once, or one that alternates. Values
             n/100 places apart have forgotten each other.
   To fill in:
     *error  the standard error of the mean
   Returns the mean of all n values.

   The grader knows the true means of 400 series. Of these, 60 to 76 of a
   hundred must be less than one error away, and 92 to 98 less than two.

   Check your answer with    make check EX=03b
   Hints, which ask before they tell:    make hint EX=03b */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

double mean_and_error(size_t n, const double x[], double *error)
{
    /* TODO: replace these lines by your own. How would you find out how far
       such means scatter, if you had not one series but thirty? */
    (void)n;
    *error = NOT_DONE_YET(x[0]);
    return x[0];
}
