/* Exercise 09e, worked: the small ones count.

   An addition rounds, and what it has dropped can be found, exactly, with
   additions that do not round. If |a| >= |b| and s is a + b as the computer
   has it, then s - a is the part of b that has arrived, and b less that is
   the part that has not.

   The larger one comes first: it need not be the sum. A number that is
   larger than all before drowns what was there, and then it is the old sum
   of which a part is missing.

   The missing parts are added up beside the sum, and join it at the very
   end. Whoever gives them back with the next number, as the method for
   steps does, loses them when that number is huge. There, in a run, what is
   added is always small.

   Infinity less infinity is no number. What is owed is then worth nothing,
   and the sum alone is the answer.

   Other ways: the error without a question which is larger, with six
   additions; or a sum for each exponent of two. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

double sum_up(size_t n, const double part[])
{
    double sum = 0.0, missing = 0.0;
    while (n-- > 0) {
        const double large = fmax(fabs(sum), fabs(part[n]));
        const double both = sum + part[n];
        missing += large == fabs(sum) ? part[n] - (both - sum)
                                      : sum - (both - part[n]);
        sum = both;
    }
    return isfinite(sum) ? sum + missing : sum;
}
