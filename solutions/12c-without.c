/* Exercise 12c, worked: leave a force out.

   The equation is that of a pencil on its tip that is pushed all the time.
   With s for the stretch, d = push (cosh(s t) - 1) / s^2; for s = 0 it is
   free fall, push t^2/2. At first the second is all there is to see: the
   series of the first begins with it, push t^2/2 (1 + (s t)^2/12 + ...).
   When s t is much more than 1, d grows as exp(s t). Whatever is left out
   in a scene that stretches so much is seen in the end.

   Why is it a bound? The true d is made of many small pushes, each of which
   has been stretched since it was given. None was larger than ours, and
   none has been stretched by more: so their sum is not more either. This is
   Gronwall's lemma. It knows nothing of directions. Where the other forces
   hold the bodies back, d only swings, with 1 - cos(s t) in place of
   cosh(s t) - 1; but who promises that they do, at all places and times?

   In C there are three traps. cosh(x) - 1 for a small x is the difference
   of two numbers near 1, and for x = 1e-9 it is 0. But it is 2 sinh(x/2)^2,
   which loses nothing. Next, 0/0 when there is no stretch: sinh(u)/u goes
   to 1 there. And a force that is none may always go, also where sinh is
   infinite: 0 times an infinity is not a number.

   The budget makes of many small bounds one. Two forces that are each just
   within the tolerance are together out of it.

   Another way: the series, as long as x is less than 1. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound)
{
    const double u = 0.5 * stretch * time;
    const double more = u > 0.0 ? sinh(u) / u : 1.0;
    *bound = push > 0.0 ? 0.5 * push * time * time * more * more : 0.0;
    const bool may = *bound <= *budget;
    if (may)
        *budget -= *bound;
    return may;
}
