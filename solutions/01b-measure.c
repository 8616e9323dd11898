/* Exercise 01b, worked: weighing without a balance.

   What the second body gains in momentum the first has lost,
   m2 (v2 - u2) = m1 (u1 - v1), so the mass ratio is the ratio of the two
   changes of velocity, the other way round. The restitution is the ratio
   of two differences. Neither asks who was at rest.

   Momentum goes from one body to the other: one change a loss, the other a
   gain, or both the other way about. When loss and gain have opposite
   signs, no positive masses can balance them. A body whose velocity has
   not changed while the other's has is a wall. Dividing the absolute
   values gives 0 or INFINITY for it; without them -6.0/0.0 would make a
   wall look like a body of negative mass.

   Another way: sit on the second body by subtracting u2 from everything.
   It is then at rest before, and the formulas of that case do. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution)
{
    const double loss = u1 - v1; /* of the first body */
    const double gain = v2 - u2; /* of the second */
    if (u1 == u2 || (loss == 0.0 && gain == 0.0))
        return false;
    if ((loss > 0.0 && gain < 0.0) || (loss < 0.0 && gain > 0.0))
        return false;
    *mass_ratio = fabs(gain) / fabs(loss);
    *restitution = (v2 - v1) / (u1 - u2);
    return true;
}
