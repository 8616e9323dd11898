/* Exercise 10a, worked: a dashpot along the axis.

   Let d be the vector from a to b, r its length and u the velocity of b as
   a sees it. The length r changes at the rate u d / r: the part of u along
   the axis. The rest of u turns the dashpot and does not stretch it. The
   force has the size c u d / r and the direction d / r, so that it is

       c (u d) d / r^2,

   and the two square roots have gone: r^2 is d d. On a it acts towards b
   while the two go apart, on b the other way round.

   What turns? The forces are equal and opposite, so the total momentum
   stays; and they act along the line between the two, so their torques
   cancel as well and the angular momentum stays. With the whole of u for
   the force the first is still true and the second is not.

   The power is the force times the rate, c (u d / r)^2. Both bodies are in
   it already: u is the velocity of one seen from the other.

   At the same place d is 0, and so is u d: 0/0 is no number, but 0 over
   anything else is what was asked for. Another way: a vector of length 1
   first, then its product with u; it costs a square root and three
   divisions. */

#include "exercise.h"

struct body {
    double x[3]; /* place, in m: x, y and z */
    double v[3]; /* velocity, in m/s */
};

double dashpot(double c, const struct body *a, const struct body *b,
               double on_a[3], double on_b[3])
{
    double square = 0.0, widens = 0.0;
    for (int k = 2; k >= 0; --k) {
        const double d = b->x[k] - a->x[k];
        square += d * d;
        widens += d * (b->v[k] - a->v[k]);
    }
    const double pull = c * widens / (square > 0.0 ? square : 1.0);
    for (int k = 0; k < 3; ++k)
        on_b[k] = -(on_a[k] = pull * (b->x[k] - a->x[k]));
    return pull * widens;
}
