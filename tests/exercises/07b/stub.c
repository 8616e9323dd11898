/* Exercise 07b. Pressure without walls (core, 30 minutes)

   A periodic box has no walls to press on. But whenever two disks collide,
   momentum J jumps over the distance of their centres, and that is as good
   as a push on a wall: the virial of the collisions tells the pressure.
   Here is a record of the collisions of a gas of hard disks or spheres, of
   different masses and radii, in which no energy is lost and the momentum
   of all of them together is zero. What is Z = P V/(N kT), and what is P?

   Given:
     dimensions   2 or 3. In 2 dimensions the third numbers of all that has
                  three mean nothing and may be anything.
     box          the sides of the box, in m; V is their product
     n            the number of particles, at least 2
     energy       kinetic energy of them all, in J
     time         how long was recorded, in s
     count        the number of collisions in that time, which may be 0
     collisions   the collisions; who of the two comes first is chance
   To fill in:
     *pressure    P, in N/m^2; in 2 dimensions it is a force per length of
                  wall, in N/m
   Returns Z. Because the momentum is zero, one particle's worth of motion
   is not free: kT = 2 energy/(dimensions (n - 1)).

   Check your answer with    make check EX=07b
   Hints, which ask before they tell:    make hint EX=07b */

#include "exercise.h"
#include <math.h>
#include <stddef.h>

struct collision {
    double mass[2];   /* kg */
    double apart[3];  /* from the first to the second at contact, m */
    double first[3];  /* velocity of the first just before, m/s */
    double second[3]; /* and of the second */
};

double compressibility(int dimensions, const double box[3], size_t n,
                       double energy, double time, size_t count,
                       const struct collision collisions[],
                       double *pressure)
{
    /* TODO: replace these lines by your own. How fast do the two centres
       approach, which momentum is exchanged, and over which distance? */
    (void)dimensions;
    (void)box;
    (void)n;
    (void)energy;
    (void)count;
    (void)collisions;
    *pressure = 0.0;
    return NOT_DONE_YET(time);
}
