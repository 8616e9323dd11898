/* Exercise 09b. Speeds for a circle (warm-up, 20 minutes)

   Which speeds let bodies that attract each other go round in circles for
   ever? The force between two of them is k2 m_1 m_2/r^2.

   binary_speeds(): two bodies, which circle their common centre of mass.
   Given:
     k2       the constant of gravity, in m^3/(kg s^2)
     m1, m2   their masses, in kg; one of them may be 0
     d        their distance from each other, in m
   To fill in:
     v1, v2   the speeds of the first and of the second, in m/s, seen from
              the centre of mass

   choreography_speed(): n equal bodies that chase each other on a circle,
   at equal distances from one to the next.
   Given:
     k2       as above
     n        how many bodies there are, at least 1
     mass     of EACH of them, in kg
     radius   of the circle, in m
   Returns the speed that all of them have, in m/s.

   The relative error of the speeds must be below 1e-12.

   Check your answer with    make check EX=09b
   Hints, which ask before they tell:    make hint EX=09b */

#include "exercise.h"
#include <stddef.h>

void binary_speeds(double k2, double m1, double m2, double d, double *v1,
                   double *v2)
{
    /* TODO: replace the lines of both functions by your own. How large is
       the circle of each, and how large is the force that bends its way? */
    (void)k2;
    (void)m1;
    (void)m2;
    *v1 = NOT_DONE_YET(d);
    *v2 = NOT_DONE_YET(d);
}

double choreography_speed(double k2, size_t n, double mass, double radius)
{
    (void)k2;
    (void)n;
    (void)mass;
    return NOT_DONE_YET(radius);
}
