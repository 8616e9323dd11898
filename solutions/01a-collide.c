/* Exercise 01a, worked: two bodies meet.

   Seen from the centre of mass both bodies come in, turn round and leave
   as fast as they came. So the velocity after is as far on the one side of
   the centre's velocity as the velocity before was on the other:
   v = c - (u - c) = 2 c - u.

   The centre's velocity is an average of u1 and u2 weighted with the
   masses. Multiply its numerator and its denominator by im1 * im2: each
   velocity is now weighted with the inverse mass of the OTHER body, nothing
   is divided by a mass, and a wall (inverse mass zero) needs no case of its
   own: its velocity is the only one left in the average.

   Another way: work with the difference d = u1 - u2 alone and take
   2 im1 / (im1 + im2) * d from the first body. It costs one operation
   fewer, and a wall then keeps its velocity to the last bit. The section
   "Speed and accuracy" compares the two. */

#include "exercise.h"

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    const double centre = (im2 * u1 + im1 * u2) / (im1 + im2);
    v[0] = 2.0 * centre - u1;
    v[1] = 2.0 * centre - u2;
}
