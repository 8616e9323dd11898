/* Exercise 12b. Other units (core, 25 minutes)

   How much of a result is rounding? Somebody has written a step for a body
   on a spring that is not quite a spring, and has given you the function,
   but not its lines. Compute the same run once more, in other units, and
   look how far the two are apart.

   Given:
     step   step(w, h, &x, &v) moves the body on by one step of h, from x to
            the new x and from v to the new v. It takes h in s, x in m, v in
            m/s, and has no unit built in: it works as well in yards and
            minutes, if ALL its numbers are in yards and minutes.
     w      the constants of the acceleration g - k x - q x^3:
            g in m/s^2, k in 1/s^2, q in 1/(m^2 s^2)
     h, n   the size of a step, in s, and how many there are
     x, v   where the run begins, in m and m/s
   To fill in:
     *end   where it ends, in m, computed in m and s
   Returns how far from *end, in m, the run ends that was computed in other
   units: a number that is not negative.

   Check your answer with    make check EX=12b
   Hints, which ask before they tell:    make hint EX=12b */

#include "exercise.h"
#include <math.h>

struct world {
    double g, k, q;
};

double apart(void (*step)(struct world w, double h, double *x, double *v),
             struct world w, double h, int n, double x, double v,
             double *end)
{
    /* TODO: replace these lines by your own. Which unit would you take in
       place of the metre, and what becomes of each number then? */
    (void)n;
    step(w, h, &x, &v);
    *end = NOT_DONE_YET(x);
    return 0.0;
}
