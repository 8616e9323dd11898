/* Exercise 05d. Pressure from a list of wall hits (core, 25 minutes)

   Disks of different masses fly about in a box with four hard walls.
   Somebody has written down each hit of a wall, and nothing else. How large
   is the pressure on the walls, in units of that of an ideal gas: Z =
   P V / (N kT)? In the plane P is a force per LENGTH of wall, and V is the
   area of the box. The walls on the left and on the right give one value,
   those at the bottom and at the top another.

   Given:
     n        the number of hits in the list, which may be none
     hits     the list, in the order of time: see struct wall_hit
     size     of the box: size[0] wide and size[1] high, in m
     disks    how many are in the box, N
     energy   the kinetic energy of all of them together, in J, which stays
              the same; with walls kT is 2 energy / (2 N), in the plane
     from     the beginning of the time that counts, in s: the disks had to
              forget their start first
     until    its end, in s, later than from. A hit at the time t counts
              when from < t <= until.
   To fill in:
     z[0]     Z from the walls on the left and on the right
     z[1]     Z from the walls at the bottom and at the top

   Check your answer with    make check EX=05d
   Hints, which ask before they tell:    make hint EX=05d */

#include "exercise.h"
#include <stddef.h>

enum wall { LEFT, RIGHT, BOTTOM, TOP };

struct wall_hit {
    double t;       /* when, in s */
    enum wall wall; /* which */
    double mass;    /* of the disk, in kg */
    double v;       /* velocity of the disk just before, in m/s: the
                       component across this wall, negative to the left and
                       downwards. Just after, it is the opposite. */
};

void wall_z(size_t n, const struct wall_hit hits[], const double size[2],
            size_t disks, double energy, double from, double until,
            double z[2])
{
    /* TODO: replace these lines by your own. How much momentum does a wall
       take in one hit, how much force is that over the whole time, and on
       which length of wall? */
    (void)n;
    (void)hits;
    (void)size;
    (void)disks;
    (void)from;
    (void)until;
    z[0] = NOT_DONE_YET(energy);
    z[1] = NOT_DONE_YET(energy);
}
