/* Hard disks and spheres in a box: starts, collisions, runs and sums. */
#ifndef DISKS_H
#define DISKS_H

#include "toolbox/random.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    DISKS_AXES = 3,        /* coordinates of a disk; in the plane the last
                              ones are zero */
    DISKS_MOST = 10000000, /* disks in a box */
    DISKS_RANDOM = 20000   /* disks that disks_place_random can place in
                              good time */
};

/* A disk or a sphere, free since its last collision: at the time t its
   centre is at position + velocity (t - since), and under gravity where
   (5.12, eq:fall) says. */
struct disk {
    double position[DISKS_AXES]; /* m; not folded back into the box */
    double since;                /* s */
    double velocity[DISKS_AXES]; /* m/s */
    double radius;               /* m */
};

/* How a box ends. FLOOR: walls across the second axis only, periodic along
   the others. */
enum disks_boundary {
    DISKS_WALLS,
    DISKS_PERIODIC,
    DISKS_FLOOR,
    DISKS_BOUNDARIES
};

/* What ends a run. */
enum disks_stop {
    DISKS_TIME,       /* the time was reached, or nothing happens again */
    DISKS_COLLISIONS, /* the number of collisions was reached */
    DISKS_COLLAPSE    /* the clock stands still: inelastic collapse */
};

/* What happens next to a disk: it meets another one or a wall. Partners
   from count on are walls: count + axis. A disk that is its own partner
   looks again: in a periodic box nobody can foresee more. */
struct disks_event {
    double time; /* s; INFINITY: nothing */
    uint32_t disk, partner;
};

/* Disks in a box from 0 to box[k] along axis k. To be read, and written
   before the first run: everything above the line. */
struct disks {
    size_t dimensions, count; /* 2 or 3; how many disks */
    enum disks_boundary boundary;
    double box[DISKS_AXES]; /* 0: open along this axis */
    double restitution;
    double gravity; /* towards the floor, m/s2; 0 in a periodic box */
    struct disk *disk;
    double *mass; /* kg */
    double now;   /* s */
    /* ---- counted by the runs */
    uint64_t collisions, wall_collisions;
    double impulse[DISKS_AXES]; /* that the walls across an axis took, Ns */
    double virial;  /* sum of distance times impulse of collisions, J s */
    uint32_t *hits; /* collisions of each disk, with disks and walls */
    uint64_t standing;       /* collisions at the time now */
    struct disks_plan *plan; /* of disks_run */
};

/* Prepares count >= 1 disks (2 or 3 dimensions): masses 1, restitution 1,
   all else 0. Returns false, with nothing to free, when there is no memory.
 */
bool disks_create(struct disks *d, size_t dimensions, size_t count);

/* Frees the disks and makes *d empty. */
void disks_free(struct disks *d);

/* Returns how long it takes, 0 at least, until the centre of a disk at x
   with the velocity v is a radius from the wall that it flies to, of two
   at 0 and length, s (5.1, eq:wall-time). INFINITY at rest. */
double disks_wall_time(double x, double v, double radius, double length);

/* Returns how long it takes, 0 at least, until the centres of two disks
   are at this distance, s (5.3, eq:pair-time): 0 for two that touch or
   overlap and approach, INFINITY for two that never meet. separation (m)
   and closing (m/s), of DISKS_AXES numbers each, are the place and the
   velocity of the second disk minus those of the first. */
double disks_pair_time(const double separation[], const double closing[],
                       double distance);

/* Returns when disks i and j will meet, s (5.10, eq:meeting): the same bits
   whenever it is asked between two collisions of theirs. In a periodic box
   the images count that are nearest at the time `at`, s, not before their
   last collisions. */
double disks_meeting(const struct disks *d, size_t i, size_t j, double at);

/* Returns when disk i will meet its next wall, s, which stands across
 *axis; INFINITY if there is no wall to meet. */
double disks_wall(const struct disks *d, size_t i, size_t *axis);

/* Says whether a comes before b: by time, and at one time by the smaller
   number of a pair and then by the larger. */
bool disks_before(struct disks_event a, struct disks_event b);

/* Returns what comes next, of all walls and all pairs. */
struct disks_event disks_next(const struct disks *d);

/* Lets the event happen: both disks move to its time and get new
   velocities; the clock, the counts and the sums follow. */
void disks_collide(struct disks *d, struct disks_event event);

/* Says whether so many collisions have taken place at the time now that
   the clock will never go on: more than a thousand and ten times count. */
bool disks_collapsed(const struct disks *d);

/* Says whether all disks are too slow for numbers, though some move: the
   squares of the fastest one's speed v, of v times the widest radius (both
   are in the time of a contact) and m v^2 have to be 2^-900 at least. That
   is 70 bits above the last number of full precision, 2^-970 before
   rounding: what two disks have between them is right down to speeds 3e10
   times slower, and slower ones meet 3e10 times later. With radii and
   masses of 1 the slowest speed is 3.5e-136 m/s. A gas that cools as far
   ends as in a collapse; under gravity none is too slow. */
bool disks_cold(const struct disks *d);

/* Says whether a run ends after a collision of disk i, for one of these two
   reasons. */
bool disks_over(const struct disks *d, size_t i);

/* Returns the first disk that lies at rest on the floor under gravity, its
   bounces too short for the clock; count if none does. With it a run ends
   as in a collapse. */
size_t disks_lying(const struct disks *d);

/* Returns how far a disk may fly before its plan is made anew, m, as other
   images may then be the nearest; INFINITY with walls. 0 if the box is too
   narrow to be periodic: no wider than four of the widest radii, or by a
   few millionths only. */
double disks_replan_distance(const struct disks *d);

/* Makes the memory for disks_run, and plans from the present state; to be
   called again after every change of the state from outside. Returns false
   if memory runs out. Requires disks_replan_distance(d) > 0. */
bool disks_plan(struct disks *d);

/* Runs until the time `until` (s), or until `collisions` pair collisions
   have been counted, whichever comes first, looking at all disks after each
   collision: time in proportion to count. The number of calls does not
   affect the results. Requires disks_plan, and a finite time unless the
   disks will meet: those that never do run for ever. */
enum disks_stop disks_run(struct disks *d, double until,
                          uint64_t collisions);

/* Fills place[DISKS_AXES] with where disk i is at the time d->now, m,
   changing nothing. Source: (5.4, eq:disk-clock). */
void disks_position(const struct disks *d, size_t i, double place[]);

/* Fills velocity[DISKS_AXES] with that of disk i at the time d->now, m/s,
   which only gravity changes between collisions. */
void disks_velocity(const struct disks *d, size_t i, double velocity[]);

/* Returns the kinetic energy, J; under gravity with that of the heights
   above the floor. */
double disks_energy(const struct disks *d);

/* Fills drift[DISKS_AXES] with the velocity of the centre of mass along
   the periodic axes, m/s, where no collision changes it, and with 0 along
   the others, where walls take the momentum. All 0, too, if its energy does
   not reach the last bit of the kinetic energy: that is what rounding
   leaves of a momentum that was taken out. */
void disks_drift(const struct disks *d, double drift[]);

/* Return the energy of the motion relative to the drift, J, which heats the
   gas (with the heights, under gravity), and kT, J, from it: 2 K / (D N -
   P), with P the number of periodic axes: along each of them N disks have N
   - 1 velocities relative to the drift. Under gravity kT is that of
   equilibrium, 2 E / ((D + 2) N - P) (7.13, eq:weight-energy). A single
   disk with no walls has none: 0. */
double disks_heat(const struct disks *d);
double disks_temperature(const struct disks *d);

/* Returns the packing: the fraction of the box that the disks fill. */
double disks_packing(const struct disks *d);

/* Says whether the box is periodic along axis k, or has walls across it;
   where it is open it is neither. */
bool disks_wraps(const struct disks *d, size_t k);
bool disks_walled(const struct disks *d, size_t k);

/* Folds a place back into the box along its periodic axes, for a table or a
   picture: in a run places are not folded. */
void disks_fold(const struct disks *d, double place[]);

/* Fills in b - a, m, in a periodic box with the image of place b that is
   nearest to place a (5.11, eq:image). */
void disks_separation(const struct disks *d, const double a[],
                      const double b[], double separation[]);

/* Says whether all disks are in the box and none overlaps another, up to
   1e-9 of the box or of their distance; if not, *a and *b are the first
   two that do, or *b = count for a wall. Looks at every pair. */
bool disks_fit(const struct disks *d, size_t *a, size_t *b);

/* Says whether disks a and b overlap now by more than disks_fit allows, or,
   with b = count, whether a sticks out of the box. */
bool disks_clash(const struct disks *d, size_t a, size_t b);

/* Places the disks, whose radii are given: on the lattice of disks packed
   closest (triangles, or face-centred cubic) that keeps them farthest
   apart, one that is wider than all others in the middle; or at random,
   one after another where there is room. Return false when they do not
   fit so. */
bool disks_place_lattice(struct disks *d);
bool disks_place_random(struct disks *d, struct random *r);

/* Gives every disk the speed v in a random direction, or a velocity of
   the temperature kT; along periodic axes with the total momentum taken
   out, and the energy kept. */
void disks_set_speed(struct disks *d, double v, struct random *r);
void disks_set_temperature(struct disks *d, double kT, struct random *r);

/* Moves every disk to where it is now, sets the clock and all counts to
   zero: for a run after a warm-up. Call disks_plan after it. */
void disks_settle(struct disks *d);

#endif
