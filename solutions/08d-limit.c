/* Exercise 08d, worked: find a stability limit.

   What a linear step makes of (1, 0) is the first column of its matrix,
   what it makes of (0, 1) the second. The eigenvalues solve
   lambda^2 - T lambda + D = 0 with the trace T and the determinant D. When
   T^2 < 4 D they are a complex pair, whose product is D: both have the
   absolute value sqrt(D). Otherwise they are real, (T +- sqrt(T^2 - 4D))/2,
   and the larger one in absolute value has the sign of T: it is
   (|T| + sqrt(...))/2. At its limit the leapfrog has the eigenvalue -1, and
   the oscillator flies from side to side: who looks for values above 1
   only does not notice.

   Why not simply make many steps, and look whether y grows? Near the limit
   it grows slowly, and it may grow for a while without being unstable: the
   leapfrog turns an ellipse, not a circle, so that even one step may
   lengthen y. Eigenvalues do not ask in which units x and v are measured.

   A method that keeps areas has D = 1, but for rounding, and complex
   eigenvalues all the way to its limit: sqrt(D) must be allowed to be a
   little more than 1. The price is that a growth of 1e-11 a step passes for
   stable. The Euler method grows by h^2/2 and is found out at 0.01 s, as is
   a method that grows by h^4/8.

   Halving wants one stable end and one unstable end, and finds one change
   between them. With the ends 0 and `most` that may be any, where a method
   is stable again beyond its limit, or none at all. So first small steps
   forward. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

void step(double h, double y[2]);

static bool stable(double h)
{
    double first[2] = {1.0, 0.0}, second[2] = {0.0, 1.0};
    step(h, first);
    step(h, second);
    const double trace = first[0] + second[1];
    const double det = first[0] * second[1] - second[0] * first[1];
    const double under = trace * trace - 4.0 * det;
    const double largest =
        under < 0.0 ? sqrt(det) : 0.5 * (fabs(trace) + sqrt(under));
    return largest <= 1.0 + 1e-11;
}

double stability_limit(double most)
{
    double low = 0.0, high = INFINITY;
    for (int i = 1; 0.01 * i <= most && isinf(high); ++i)
        if (stable(0.01 * i))
            low = 0.01 * i;
        else
            high = 0.01 * i;
    if (isinf(high) || low <= 0.0)
        return isinf(high) ? INFINITY : 0.0;
    while (high - low >= 1e-10) {
        const double middle = 0.5 * (low + high);
        if (stable(middle))
            low = middle;
        else
            high = middle;
    }
    return low;
}
