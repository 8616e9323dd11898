/* Exercise 07a, worked: how fast is a disk?

   All the squares of the speeds together are n times their mean. A disk
   with the speed v has the share s = v^2/(n mean_square) of them, and is
   slower than that with the probability 1 - (1 - s)^(n-1). The formula is
   right and a poor program. For a small s, 1 - s forgets the last digits of
   s, or all of it; for many disks the power makes what has been forgotten n
   times as large; and 1 minus something near 1 has hardly a digit left.
   log1p(-s) is the logarithm of 1 - s without 1 - s, and expm1(y) is
   e^y - 1 without 1: between the two nothing is near 1 any more. What is
   left are a few roundings.

   For n = 2 the law is s itself: two disks share the energy in all ways
   alike. For n = 1 the factor n - 1 makes 0 of every probability below the
   only speed there is, and the case of s above 1 makes 1 of the others. For
   large n it becomes 1 - e^(-v^2/mean_square).

   The fourth power: the mean of s^2 is the integral of 2 s (1 - s)^(n-1)
   from 0 to 1, which is 2/(n (n + 1)), and v^4 is s^2 times the square of n
   mean_square. So it is 2n/(n + 1) mean_square^2: the square of the mean
   for one disk, twice that for many. In C, 2 * n / (n + 1) is 1 whatever n
   is, for whole numbers; and n * n is too large for an int.

   Another way: b = 1 - (1 - s)^k obeys b -> b (2 - b) when k is doubled and
   b -> b + s (1 - b) when it grows by one. Nothing cancels there, and
   thirty steps are enough for a thousand million disks. */

#include "exercise.h"
#include <math.h>

double speed_below(int n, double mean_square, double v, double *fourth)
{
    const double disks = n;
    const double share = v * v / (disks * mean_square);
    *fourth = 2.0 / (1.0 + 1.0 / disks) * mean_square * mean_square;
    if (v <= 0.0)
        return 0.0;
    if (share >= 1.0)
        return 1.0;
    return -expm1((disks - 1.0) * log1p(-share));
}
