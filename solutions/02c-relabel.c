/* Exercise 02c, worked: a million seconds, no collision.

   Two equal masses that collide exchange their velocities. Whoever cannot
   tell them apart sees two that pass through each other. So let a ghost go
   through everything but the walls, one for each body: at any time there is
   a body where there is a ghost, with the ghost's velocity. Only which body
   it is changes. Bodies cannot pass, so the k-th from the left at time 0 is
   the k-th from the left for ever: sort the ghosts, each with its velocity,
   and number them anew.

   A ghost between two walls is as easy. Put a mirror on the wall: the ghost
   goes on behind it, x0 + v0 t, as far as it likes. Its picture repeats
   after two lengths of the box, there and back. In the first half of such a
   period it moves in the direction of v0, in the second half it comes back.
   fmod() takes the whole periods off without any error of its own; it keeps
   the sign, so ghosts that went to the left need one period more.

   What is left is the error of the product v0 t: half an epsilon of up to a
   million metres. Nothing has been summed up, and the millionth second is
   no worse than that. A program that goes from collision to collision is
   wrong by more, and it must visit them all.

   Another way: count, for each ghost, how many are to the left of it; that
   number is its place, and nothing needs to be moved. */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

void positions_at(size_t n, double length, const double x0[],
                  const double v0[], double t, double x[], double v[])
{
    for (size_t ghost = 0, k; ghost < n; ++ghost) {
        double place = fmod(x0[ghost] + v0[ghost] * t, 2.0 * length);
        double velocity = v0[ghost];
        if (place < 0.0)
            place += 2.0 * length;
        if (place > length) {
            place = 2.0 * length - place;
            velocity = -velocity;
        }
        /* Move those to the right of it one place on. */
        for (k = ghost; k > 0 && x[k - 1] > place; --k) {
            x[k] = x[k - 1];
            v[k] = v[k - 1];
        }
        x[k] = place;
        v[k] = velocity;
    }
}
