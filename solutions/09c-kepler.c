/* Exercise 09c, worked: Kepler's equation.

   First make it small. Whole revolutions are the same for E and M, and with
   -M comes -E: it is enough to solve for 0 <= M <= pi. What is found is
   E - M, which is added to the M that was given: so no revolution is lost.

   There f(E) = E - e sin(E) - M rises, and it is convex, because its second
   derivative e sin(E) is not negative. Newton's rule draws the tangent, and
   the tangent of a convex function lies below it: from a point to the right
   of the solution the next point is nearer and still to the right. So the
   way goes down and cannot run away. A start that is surely to the right is
   M + e, since sin(E) is at most 1; and pi is another one. The start E = M
   is to the left. There the slope 1 - e cos(E) may be tiny, for an ellipse
   as long as a comet's near the sun, and the tangent then hits the axis far
   away: with e = 0.99 and M = 0.1 at about E = 6.7, and from there it goes
   on at random.

   When is it done? The way goes down until rounding stops it: the first
   step that does not go down is the end. A test for a step below some small
   number would have to know how small; too small, and the loop never ends.

   How good is it? E - e sin(E) is rounded by an epsilon or two of E, and E
   moves by that over the slope. For e near 1 and M near 0 the slope is 1 -
   e and digits are lost; who needs them must write 1 - e in another way.

   Another way: f(M - e) <= 0 <= f(M + e), so halving that interval cannot
   fail. It takes 53 sines where Newton takes five or ten. */

#include "exercise.h"
#include <math.h>

double eccentric_anomaly(double e, double mean)
{
    const double pi = acos(-1.0);
    const double within = remainder(mean, 2.0 * pi), m = fabs(within);
    double last, now = fmin(m + e, pi);
    do {
        last = now;
        now = last - (last - e * sin(last) - m) / (1.0 - e * cos(last));
    } while (now < last);
    return mean + copysign(last - m, within);
}
