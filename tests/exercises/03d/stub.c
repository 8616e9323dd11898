/* Exercise 03d. Block errors on a correlated series (core, 30 minutes)

   The values of a run hang together: what comes next is like what was
   before. So the mean is less certain than as many independent values
   would make it. Cut the series into blocks, longer than its memory. The
   means of the blocks are nearly independent, and THEIR scatter tells.

   Given:
     n               how many values there are
     x               x[0] to x[n - 1], in the order of the run, not all the
                     same; they may be small differences between large
                     numbers
     length          of a block. Blocks lie end to end from x[0] on; values
                     left over at the end that fill no block are used for
                     nothing at all.
   To fill in:
     *error          the standard error of the mean of the values used, from
                     the scatter of the block means
     *inefficiency   g: the square of that error, divided by the square of
                     the standard error that the same values would give if
                     each were independent
   Both variances are estimated as usual, with one less than the number in
   the denominator. Returns false, and *error and *inefficiency do not
   matter, when there are fewer than two blocks or length is 0; else true.

   Check your answer with    make check EX=03d
   Hints, which ask before they tell:    make hint EX=03d */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool error_by_blocks(size_t n, const double x[], size_t length,
                     double *error, double *inefficiency)
{
    /* TODO: replace these lines by your own. How many blocks are full? What
       is the standard error of the mean of so many independent numbers? */
    (void)n;
    (void)length;
    *error = NOT_DONE_YET(x[0]);
    *inefficiency = NOT_DONE_YET(1.0);
    return true;
}
