/* Exercise 04b, worked: one blow at a time.

   One blow first. Seen from the wall a particle comes in with w = v - V and
   goes out with -w, if the wall is heavy; a wall that gives way takes up
   2 w / (1/m + im), which is the impulse of every elastic collision.

   Then their number. In a second the particle comes nearer by |w|, so those
   within |w| of the wall arrive: |w| times what there is in a metre. V is
   in both factors, and that is where the 2 comes from: the force of a sort
   on the left goes as (v - V)^2 = v^2 - 2 v V + V^2, and the last is left
   out.

   From the right the force points to the left, but there w grows with V.
   Two signs have changed, and the friction has the same sign as on the
   left: pressures are subtracted, frictions add up.

   To first order nobody asks whether a particle at rest is run over: its
   force goes as V^2. That is also why V must be small compared with all
   others. In a gas a few are slower than the wall; that they are few, and
   slow, makes their share one of the third order.

   Another way: the exact force at V and at -V, whose half difference has no
   V^2 in it. It loses digits when V is very small. */

#include "exercise.h"
#include <stddef.h>

struct sort {
    double m, v;        /* in kg and m/s */
    double left, right; /* in 1/m: how many, on this side of the wall */
};

double rain_force(size_t n, const struct sort rain[], double im, double V,
                  double *friction)
{
    double pressure = *friction = 0.0;
    for (const struct sort *s = rain; n > 0; --n, ++s) {
        const double turned = 2.0 / (1.0 / s->m + im);
        const double blows = s->v * (s->v > 0.0 ? s->left : -s->right);
        pressure += turned * s->v * blows;
        *friction += 2.0 * turned * blows;
    }
    return pressure - *friction * V;
}
