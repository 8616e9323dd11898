/* Exercise 06c. Pushed together by nothing (stretch, 35 minutes)

   Two big bodies swim among many small ones. The centre of a small one
   cannot come closer to a big one than the sum of their radii: around each
   big body is a zone without small centres. Where the zones of the two
   overlap, the small ones gain room; so they push the big ones together.
   This is the potential of Asakura and Oosawa; here the two big bodies need
   not be equal.

   Given:
     dimensions  2 for disks, 3 for spheres
     R1, R2      the radii of the two big bodies, in m, positive
     small       the radius of the small ones, in m; it may be 0
     density     how many small ones there are in 1 m^2 (1 m^3 for spheres)
     r           the distance of the two big centres, in m, positive
   To fill in:
     *overlap    the area (2) or the volume (3) that the two zones share, in
                 m^2 or m^3; 0 where they do not meet. If the big bodies
                 themselves overlap it is not asked for.
   Returns the potential, as a multiple of kT: what it costs to bring the
   two to this distance from far away. It is INFINITY where the big bodies
   overlap; two that touch do not.

   Check your answer with    make check EX=06c
   Hints, which ask before they tell:    make hint EX=06c */

#include "exercise.h"
#include <math.h>

double depletion(int dimensions, double R1, double R2, double small,
                 double density, double r, double *overlap)
{
    /* TODO: replace these lines by your own. Two circles cut each other in
       a chord. How far is it from either centre, and what does it cut off
       each circle? */
    (void)dimensions;
    (void)R1;
    (void)R2;
    (void)small;
    (void)r;
    *overlap = 0.0;
    return NOT_DONE_YET(density);
}
