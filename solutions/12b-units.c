/* Exercise 12b, worked: other units.

   A step of 0.7 m/s for a quarter of a second and one of 1 length/s: to the
   physics that is the same, to the last bits it is not. Every product and
   every sum is rounded elsewhere, so the two ends differ by what rounding
   has done to them, grown as the scene lets it grow. No truth was needed,
   and nobody has looked into the step.

   Only the length is changed here, by a unit of 0.7 m. Then x, v and g are
   divided by it, k has no length in its unit and stays, and q, in
   1/(m^2 s^2), is multiplied by its square: what is shorter than a metre
   has larger numbers, and a square metre has yet more of its squares. The
   second could be changed as well; then h, v and the constants change
   again, and the roundings are no more independent than they were.

   Not 0.5: a factor of two only changes the exponent, every digit stays
   where it was, and both runs agree to the last bit. That says nothing.

   How good is it? Two independent errors differ by sqrt(2) of one, in the
   mean. In a single run the difference may happen to be small, so the
   program of this chapter counts it twice and looks at all its rows. */

#include "exercise.h"
#include <math.h>

struct world {
    double g, k, q;
};

static const double unit = 0.7; /* m */

typedef void stepper(struct world w, double h, double *x, double *v);

static double last(stepper *step, struct world w, double h, int n, double x,
                   double v)
{
    while (n-- > 0)
        step(w, h, &x, &v);
    return x;
}

double apart(stepper *step, struct world w, double h, int n, double x,
             double v, double *end)
{
    const struct world in_units = {w.g / unit, w.k, w.q * (unit * unit)};
    *end = last(step, w, h, n, x, v);
    return fabs(unit * last(step, in_units, h, n, x / unit, v / unit) -
                *end);
}
