/* Exercise 11b, worked: what leaves the cradle.

   However tiny the gaps are, the collisions come one after the other, and
   the size of the gaps does not matter: with gaps half as wide everything
   happens twice as fast. So we take them to be 1 m wide, and do what
   chapter 2 did: look for the pair that meets next, let everybody move
   until then, let the two collide, look again.

   Only gaps are needed, no places. A gap shrinks at the rate v[i] - v[i+1].
   For two that meet, the centre of mass has the velocity c, and each has
   2 c minus its own afterwards.

   For equal masses the velocities are only handed on, and any order will
   do. With one heavy ball it still does: it knocks on the row again and
   again, and each time the last ball that is free takes what is handed
   through. In general the order matters, which is why a program that takes
   time steps longer than a gap, and goes through the row from left to
   right, has a cradle of its own.

   The threshold is not for beauty. Of the three balls that leave together,
   one may be faster than the next by a rounding. They would meet after some
   1e16 gaps, and be counted.

   Another way: a calendar. A collision changes two velocities, and only the
   times of the pairs next to it need to be found anew. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

enum { MOST = 100 };

/* The pair that meets next, counted by its left ball, and in how many
   seconds; n when there is none. */
static size_t next_pair(size_t n, const double gap[], const double v[],
                        double slow, double *wait)
{
    size_t next = n;
    *wait = INFINITY;
    for (size_t i = n; i-- > 1;) {
        const double rate = v[i - 1] - v[i];
        if (rate > slow && gap[i] < rate * *wait) {
            *wait = gap[i] / rate;
            next = i - 1;
        }
    }
    return next;
}

size_t cradle(size_t n, const double mass[], double v[])
{
    double gap[MOST], fastest = 0.0, wait;
    size_t collisions = 0, ball = n;
    while (ball-- > 0) {
        gap[ball] = 1.0;
        fastest = fmax(fastest, fabs(v[ball]));
    }
    for (;; ++collisions) {
        const size_t k = next_pair(n, gap, v, 1e-9 * fastest, &wait);
        if (k == n)
            return collisions;
        for (size_t i = n; --i > 0;)
            gap[i] += wait * (v[i] - v[i - 1]);
        gap[k + 1] = 0.0;
        const double *m = mass + k;
        const double c = (m[0] * v[k] + m[1] * v[k + 1]) / (m[0] + m[1]);
        v[k] = 2.0 * c - v[k];
        v[k + 1] = 2.0 * c - v[k + 1];
    }
}
