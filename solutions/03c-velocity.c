/* Exercise 03c, worked: the exact law of the velocities.

   Two laws are known at sight. For n = 3 the density is 1/2 everywhere, so
   F = (1 + u)/2; for n = 2 it is that of the arcsine, F = 1/2 +
   asin(u)/pi. All the others follow in steps of two. Integrate
   (1 - s^2)^k by parts, with 1 for the factor that is integrated:
       (2k + 1) I_k(u) = u (1 - u^2)^k + 2k I_{k-1}(u),
   where 2k = n - 3, and k - 1 belongs to n - 2. From -1 to 1 the first
   term is gone, so the constants obey C_n = C_{n-2} (n - 2)/(n - 3), and
   after division by the whole integral
       F_n(u) = F_{n-2}(u) + C_n u (1 - u^2)^((n-3)/2) / (n - 2).
   What is added for one n follows from what was added for n - 2: it is
   multiplied by (1 - u^2) (n - 4)/(n - 3). In the loop below, term is what
   belongs to k, and the last line makes that of k + 2 from it.

   Everything that is added has the sign of u, so nothing cancels, and the
   error is a few epsilons for any n. The product (1 - u)(1 + u) keeps its
   digits near the ends, where 1 - u^2 would lose them.

   Another way: with u = sin(theta) the density becomes C_n times
   cos(theta)^(n-2), which has no corner anywhere, and Simpson's rule does
   well. To multiply (1 - u^2)^k out is no way: for a hundred movers its
   terms are as large as 1e13, have alternating signs, and leave no digit
   that is right. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

double velocity_below(int n, double u)
{
    if (fabs(u) >= 1.0)
        return u < 0.0 ? 0.0 : 1.0;
    const double pi = acos(-1.0);
    const double rest = (1.0 - u) * (1.0 + u);
    const bool even = n % 2 == 0;
    double below = 0.5 + (even ? asin(u) / pi : 0.5 * u);
    double term = even ? u * sqrt(rest) / pi : 0.25 * u * rest;
    for (int k = even ? 4 : 5; k <= n; k += 2) {
        below += term;
        term *= rest * (k - 2) / (k - 1);
    }
    return below;
}
