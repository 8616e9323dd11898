/* Exercise 10a. A dashpot along the axis (warm-up, 20 minutes)

   Two bodies are joined by a dashpot: a piston in a cylinder full of oil.
   It resists when its length changes, with a force of c times the rate at
   which the length does, along the line from one body to the other. The
   damper that is printed with the scenes takes the whole relative velocity
   instead, and so it brakes bodies that only turn about each other. Yours
   must let them turn.

   Given:
     c        the damping, in kg/s, not negative
     a, b     the two bodies, with place and velocity. They are between
              1e-100 and 1e100 m apart, or at the very same place. There the
              dashpot has no direction, and its force is 0.
   To fill in:
     on_a     the force on body a, in N: on_a[0] along x, then y and z
     on_b     the force on body b, in N
   Returns the power that the dashpot turns into heat, in W, which is never
   negative.

   Check your answer with    make check EX=10a
   Hints, which ask before they tell:    make hint EX=10a */

#include "exercise.h"

struct body {
    double x[3]; /* place, in m: x, y and z */
    double v[3]; /* velocity, in m/s */
};

double dashpot(double c, const struct body *a, const struct body *b,
               double on_a[3], double on_b[3])
{
    /* TODO: replace these lines by your own. How fast does the distance of
       the two grow, and which way does that force pull each of them? */
    (void)a;
    (void)b;
    for (int k = 0; k < 3; ++k)
        on_a[k] = on_b[k] = NOT_DONE_YET(0.0);
    return c;
}
