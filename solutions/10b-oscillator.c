/* Exercise 10b, worked: the oscillator in closed form.

   Let g = c/(2m) be the rate of damping and w^2 = D/m. What is left of x
   when the envelope exp(-g t) is taken out of it obeys y" = (g^2 - w^2) y:
   an oscillator without damping, or one that runs away. It has an even
   solution C and an odd one S, with C = 1, S = 0, C' = 0 and S' = 1 at the
   start, and

       x = exp(-g t) (x0 C + (v0 + g x0) S),
       v = exp(-g t) (v0 C - (g v0 + w^2 x0) S).

   The second line follows from the first and from C' = (g^2 - w^2) S. With
   n^2 = |g^2 - w^2|, S is sin(n t)/n, t or sinh(n t)/n: one function, and
   an even one of n, which is why nothing happens at the critical damping.
   Whoever divides by n only where the sine is keeps its digits there: n
   has lost half of them, but sin(n t)/n does not care. The usual form, two
   exponentials with factors of 1/(2 n), has two large terms that cancel.

   With much damping there are two more traps. The hyperbolic functions
   overflow while the envelope goes to zero. So we take the slower of the
   two exponentials out of everything; what is left is between 0 and 1. And
   the slow rate is g - n, a small difference of two large numbers; but the
   product of both rates is w^2, so it is w^2/(g + n) as well.

   Last, g^2 - w^2 is written as a product, (w - g)(w + g), which costs
   nothing and saves a digit or two.

   Another way: the matrix exponential, by squaring. It loses digits with
   much damping and long times. */

#include "exercise.h"
#include <math.h>

struct oscillator {
    double mass;      /* m, in kg, positive */
    double damping;   /* c, in kg/s, not negative */
    double stiffness; /* D, in N/m, positive */
    double x;         /* place at the time 0, in m; 0 is that of rest */
    double v;         /* velocity at the time 0, in m/s */
};

/* What multiplies the start: the even and the odd solution, each with its
   envelope. */
struct pair {
    double even, odd;
};

static struct pair swinging(double g, double n, double t)
{
    const double envelope = exp(-g * t);
    return (struct pair){envelope * cos(n * t), envelope * sin(n * t) / n};
}

static struct pair creeping(double g, double n, double square, double t)
{
    const double slow = exp(-t * (square / (g + n)));
    const double lag = expm1(-2.0 * n * t);
    return (struct pair){slow * (1.0 + 0.5 * lag),
                         n > 0.0 ? -slow * lag / (2.0 * n) : slow * t};
}

double oscillate(const struct oscillator *o, double t, double *velocity)
{
    const double g = 0.5 * o->damping / o->mass;
    const double square = o->stiffness / o->mass, w = sqrt(square);
    const double n = sqrt(fabs(w - g) * (w + g));
    const struct pair p =
        g < w ? swinging(g, n, t) : creeping(g, n, square, t);
    *velocity = p.even * o->v - p.odd * (g * o->v + square * o->x);
    return p.even * o->x + p.odd * (o->v + g * o->x);
}
