/* Exercise 03d, worked: block errors on a correlated series.

   B blocks of L values have B means. Their mean is that of all values used,
   and if the blocks are independent its variance is the variance of the
   block means divided by B. The naive error takes every value for a block
   of its own: it is the same formula with B L blocks of length 1. The
   ratio of the two squares says how many values are worth one.

   Two things in the code are worth a look. First, a block enters with the
   square of the SUM of its deviations; a mean is that sum divided by L, so
   L^2 goes into the denominator at the end. Deviations that have the same
   sign within a block add up before they are squared: that is how memory
   shows.

   Second, everything is measured from the mean, which is found first. The
   formula <x^2> - <x>^2 needs one pass only, but with values near 1e9 and
   a scatter of 1 it subtracts two numbers near 1e18, of which a double
   knows sixteen digits: nothing is left, or less than nothing. A small
   error d of the mean does no harm here: it adds d^2 to the variance.

   Values at the end that fill no block are left out of the mean and of the
   naive error too. Otherwise g would compare two different series.

   Another way: an array of the block means, and one function for the
   variance of an array, called twice. Or, in a single pass, Welford's
   update of mean and variance. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool error_by_blocks(size_t n, const double x[], size_t length,
                     double *error, double *inefficiency)
{
    const size_t blocks = length > 0 ? n / length : 0;
    if (blocks < 2)
        return false;
    const double b = (double)blocks, all = b * (double)length;
    const double *const end = x + blocks * length;
    double mean = x[0];
    for (const double *value = x; value < end; ++value)
        mean += (*value - x[0]) / all;

    double by_value = 0.0, by_block = 0.0; /* sums of squares */
    for (const double *value = x; value < end;) {
        const double *const next = value + length;
        double sum = 0.0;
        for (; value < next; ++value) {
            sum += *value - mean;
            by_value += (*value - mean) * (*value - mean);
        }
        by_block += sum * sum;
    }
    by_block /= (double)length * (double)length;
    *error = sqrt(by_block / (b * (b - 1.0)));
    *inefficiency = *error * *error / (by_value / (all * (all - 1.0)));
    return true;
}
