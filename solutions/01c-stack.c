/* Exercise 01c, worked: a stack of balls is dropped.

   Ride down with the stack. Seen from there all balls are at rest and the
   floor comes up with the speed of arrival. The floor, a wall, gives the
   lowest ball 1 + e times its own speed. From then on the same thing
   happens again and again: a moving ball hits one at rest and gives it
   1 + e times the velocity of their centre of mass, which is the lower
   ball's share m[k] / (m[k] + m[k + 1]) of what it has. So the velocity
   goes up the stack as one number, multiplied once for each ball. At the
   end we step off again and subtract the speed of the fall.

   The limits can be read off. When each ball is far heavier than the next,
   every share is 1 and the top leaves with ((1 + e)^n - 1) times the speed:
   3 times for two elastic balls, 2^n - 1 times for n. When all masses are
   equal every share is 1/2, and n elastic balls do no better than one.

   Another way: stay on the ground and apply the collision rule with
   restitution to the pairs, from the bottom up, keeping only the velocity
   of the upper ball of each. That needs no idea, and both velocities in
   every step. */

#include "exercise.h"
#include <stddef.h>

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution)
{
    const double gain = 1.0 + restitution;
    double relative = gain * speed; /* seen from the falling stack */
    for (size_t k = 1; k < n; ++k)
        relative *= gain * masses[k - 1] / (masses[k - 1] + masses[k]);
    return relative - speed;
}
