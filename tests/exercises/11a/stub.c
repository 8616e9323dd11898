/* Exercise 11a. Push two spheres apart (warm-up, 20 minutes)

   After a time step two spheres overlap. Push them apart, along the line
   from one centre to the other and just so far that they touch, and leave
   their centre of mass where it is. Both masses and radii differ.

   Given:
     a, b     the two spheres. Either of the masses may be INFINITY, which
              is how a program says that this one cannot be moved; not both.
              The centres are 1e-100 m apart or more, or at the very same
              place. Then there is no line: push a towards smaller x and b
              towards larger.
   To change:
     a->x, b->x   the centres, if the two overlap. If they touch or are
              apart, not a bit of them changes, and that of an immovable
              sphere never does.
   Returns how deep the overlap was, in m: by how much the distance of the
   centres was too small. 0 if they touch or are apart.

   Check your answer with    make check EX=11a
   Hints, which ask before they tell:    make hint EX=11a */

#include "exercise.h"
#include <math.h>

struct sphere {
    double mass;   /* kg, or INFINITY */
    double radius; /* m */
    double x[3];   /* the centre, in m */
};

double part_spheres(struct sphere *a, struct sphere *b)
{
    /* TODO: replace these lines by your own. When a heavy one and a light
       one are pushed apart, which of them goes further? */
    (void)a;
    (void)b;
    return NOT_DONE_YET(0.0);
}
