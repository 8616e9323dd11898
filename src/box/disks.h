/* Hard disks and spheres in a box: starts, collisions, runs, energy. */
#ifndef DISKS_H
#define DISKS_H

#include "toolbox/random.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    DISKS_AXES = 3,        /* coordinates; in the plane the third is 0 */
    DISKS_MOST = 10000000, /* largest number of disks */
    DISKS_RANDOM = 20000   /* largest number for disks_place_random */
};

/* A disk or a sphere. Until its next collision its centre at the time t is
   at position + velocity (t - since); (5.12, eq:fall) adds gravity. */
struct disk {
    double position[DISKS_AXES]; /* m; not folded back into the box */
    double since;                /* s */
    double velocity[DISKS_AXES]; /* m/s */
    double radius;               /* m */
};

/* The boundaries of a box. FLOOR: walls across the second axis only,
   periodic along the others. */
enum disks_boundary {
    DISKS_WALLS,
    DISKS_PERIODIC,
    DISKS_FLOOR,
    DISKS_BOUNDARIES
};

/* The reasons why a run ended. */
enum disks_stop {
    DISKS_TIME,       /* time reached, or no event left */
    DISKS_COLLISIONS, /* number of collisions reached */
    DISKS_COLLAPSE    /* the clock stands still, or disks are too slow */
};

/* The next event of a disk: a collision with another disk or a wall.
   Partner numbers from count on stand for walls: count + axis. If a disk is
   its own partner, it needs a new plan: in a periodic box plans have a
   limited range. */
struct disks_event {
    double time; /* s; INFINITY: no event */
    uint32_t disk, partner;
};

/* Disks in a box from 0 to box[k] along axis k. The members above the line
   may be read, and written before the first run. */
struct disks {
    size_t dimensions, count; /* 2 or 3; number of disks */
    enum disks_boundary boundary;
    double box[DISKS_AXES]; /* sides, m; 0 if open along this axis */
    double restitution;
    double gravity; /* towards the floor, m/s2; 0 in a periodic box */
    struct disk *disk;
    double *mass; /* kg */
    double now;   /* s */
    /* ---- written by the runs */
    uint64_t collisions, wall_collisions;
    double impulse[DISKS_AXES]; /* given to the walls across an axis, N s */
    double virial;  /* sum of distance times impulse in collisions, J s */
    uint32_t *hits; /* collisions of each disk, also with walls */
    uint64_t standing;       /* collisions at the present time */
    struct disks_plan *plan; /* private to disks_run */
};

/* Prepares count >= 1 disks in 2 or 3 dimensions with masses 1, restitution
   1, all else 0. Returns false, with nothing to free, if memory runs
   out. */
bool disks_create(struct disks *d, size_t dimensions, size_t count);

/* Frees the disks and makes *d empty. */
void disks_free(struct disks *d);

/* Returns the time, s, at least 0, until the centre of a disk at x with the
   velocity v is a radius away from the wall ahead of it, at 0 or at length,
   m (5.1, eq:wall-time); INFINITY at rest. */
double disks_wall_time(double x, double v, double radius, double length);

/* Returns the time, s, at least 0, until the centres of two disks are at
   this distance, m (5.3, eq:pair-time): 0 for two that touch or overlap and
   approach, INFINITY for two that never meet. separation (m) and closing
   (m/s), with DISKS_AXES components, are position and velocity of the
   second disk relative to the first. */
double disks_pair_time(const double separation[], const double closing[],
                       double distance);

/* Returns the time, s, at which disks i and j will meet (5.10, eq:meeting).
   It is equal to the last bit for all calls until one of them collides
   again. In a periodic box it takes the images that are nearest at the time
   `at`, s, which is not before the last collision of either. */
double disks_meeting(const struct disks *d, size_t i, size_t j, double at);

/* Returns the time, s, at which disk i will meet its next wall, or INFINITY
   if it meets none; sets *axis to the axis across which that wall lies. */
double disks_wall(const struct disks *d, size_t i, size_t *axis);

/* Returns whether event a comes before b: by time, and at equal times by
   the smaller number of the pair, then by the larger. */
bool disks_before(struct disks_event a, struct disks_event b);

/* Returns the earliest event of all walls and all pairs. */
struct disks_event disks_next(const struct disks *d);

/* Carries out an event: moves its disks to its time, gives them new
   velocities, and updates the clock, the counts and the sums. */
void disks_collide(struct disks *d, struct disks_event event);

/* Returns whether more than 1000 + 10 count collisions have taken place at
   the present time, so that the clock will never advance again. */
bool disks_collapsed(const struct disks *d);

/* Returns whether all disks are too slow for double precision, though some
   move. With v the speed of the fastest disk, v^2, (v times the largest
   radius)^2, which the time of a contact needs, and m v^2 must be at least
   2^-900. Squares of speeds 3e10 times lower, 2^-970, still have full
   precision; such slow disks meet 3e10 times later. With radii and masses
   of 1 the slowest speed is 3.5e-136 m/s. A gas that gets colder ends as in
   a collapse; under gravity no speed is too slow. */
bool disks_cold(const struct disks *d);

/* Returns, after a collision of disk i, whether the run must end because of
   disks_collapsed or disks_cold. */
bool disks_over(const struct disks *d, size_t i);

/* Returns the first disk that lies at rest on the floor under gravity, its
   bounces too short for the clock, or count if there is none. Such a disk
   ends a run as a collapse does. */
size_t disks_lying(const struct disks *d);

/* Returns the distance, m, that a disk may fly before it needs a new plan,
   since other images may then be the nearest; INFINITY with walls, 0 if the
   box is too narrow to be periodic: less than a few millionths wider than
   four of the largest radii. */
double disks_replan_distance(const struct disks *d);

/* Allocates the plans for disks_run, and plans from the present state. To
   be called again after every change of the state from outside. Returns
   false if memory runs out. Requires disks_replan_distance(d) > 0. */
bool disks_plan(struct disks *d);

/* Runs until the time `until` (s), or until `collisions` pair collisions
   have been counted, whichever comes first. It examines all disks after
   each collision, in a time proportional to count. The number of calls does
   not affect the results. Requires disks_plan, and a finite time if the
   disks may never meet again, or it would not return. */
enum disks_stop disks_run(struct disks *d, double until,
                          uint64_t collisions);

/* Fills place[DISKS_AXES] with the position of disk i at the time d->now, m
   (5.4, eq:disk-clock). Changes nothing. */
void disks_position(const struct disks *d, size_t i, double place[]);

/* Fills velocity[DISKS_AXES] with the velocity of disk i at the time
   d->now, m/s, which only gravity changes between collisions. */
void disks_velocity(const struct disks *d, size_t i, double velocity[]);

/* Returns the kinetic energy, J; under gravity with the potential energy,
   which is 0 for disks on the floor. */
double disks_energy(const struct disks *d);

/* Fills drift[DISKS_AXES] with the velocity of the centre of mass along the
   periodic axes, m/s, where no collision changes it, and with 0 along the
   others, where walls take the momentum. All are 0 if the energy of the
   drift is below the last bit of the kinetic energy: then the drift is a
   rounding error of a start without momentum. */
void disks_drift(const struct disks *d, double drift[]);

/* Return the energy of the motion relative to the drift, J, with the
   potential energy under gravity, and the temperature kT, J, that follows
   from it: 2 K / (D N - P), with P the number of periodic axes, along each
   of which N disks have only N - 1 independent relative velocities. Under
   gravity kT is that of equilibrium, 2 E / ((D + 2) N - P) (7.13,
   eq:weight-energy). kT is 0 for a single disk without walls. */
double disks_heat(const struct disks *d);
double disks_temperature(const struct disks *d);

/* Returns the packing fraction: the area (volume) of all disks divided by
   that of the box. */
double disks_packing(const struct disks *d);

/* Return whether the box is periodic along axis k, and whether it has walls
   across this axis; an open box has neither. */
bool disks_wraps(const struct disks *d, size_t k);
bool disks_walled(const struct disks *d, size_t k);

/* Folds a position back into the box along its periodic axes, for a table
   or a picture: during a run positions are not folded. */
void disks_fold(const struct disks *d, double place[]);

/* Fills separation with b - a, m; in a periodic box b is replaced by its
   image nearest to a (5.11, eq:image). */
void disks_separation(const struct disks *d, const double a[],
                      const double b[], double separation[]);

/* Returns whether all disks are in the box and none overlaps another by
   more than 1e-9 of the box or of their distance. If not, *a and *b are the
   first two that overlap, or *b = count for a wall. Examines every pair. */
bool disks_fit(const struct disks *d, size_t *a, size_t *b);

/* Returns whether disks a and b now overlap by more than disks_fit allows;
   with b = count, whether disk a extends beyond the walls. */
bool disks_clash(const struct disks *d, size_t a, size_t b);

/* Place the disks, whose radii are given, on that close-packed lattice
   (triangular or face-centred cubic) which keeps them farthest apart, with
   a disk wider than all others in the middle; or at random, one after
   another. Return false if the disks do not fit. */
bool disks_place_lattice(struct disks *d);
bool disks_place_random(struct disks *d, struct random *r);

/* Give every disk the speed v in a random direction, or a random velocity
   of the temperature kT; along periodic axes the total momentum is then
   removed and the energy restored. */
void disks_set_speed(struct disks *d, double v, struct random *r);
void disks_set_temperature(struct disks *d, double kT, struct random *r);

/* Moves every disk to its present position and sets the clock and all
   counts to zero, as after a warm-up. disks_plan must be called again after
   it. */
void disks_settle(struct disks *d);

#endif
