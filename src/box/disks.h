/* Simulates hard disks and spheres in a box, from event to event. */
#ifndef DISKS_H
#define DISKS_H

#include "toolbox/random.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    DISKS_AXES = 3,        /* number of coordinates; in the plane the third
                              is 0 */
    DISKS_MOST = 10000000, /* largest number of disks */
    DISKS_RANDOM = 20000   /* largest number for disks_place_random */
};

/* A disk or a sphere. Until its next collision, its centre at the time t is
   at position + velocity (t - since). Gravity adds to this (5.12,
   eq:fall). */
struct disk {
    double position[DISKS_AXES]; /* m; not folded back into the box */
    double since;                /* time of position and velocity, s */
    double velocity[DISKS_AXES]; /* m/s */
    double radius;               /* m */
};

/* The boundaries of a box. With DISKS_FLOOR it has a floor and a roof,
   perpendicular to the second axis, and is periodic along the others. */
enum disks_boundary {
    DISKS_WALLS,
    DISKS_PERIODIC,
    DISKS_FLOOR,
    DISKS_BOUNDARIES
};

/* Why a run ended. */
enum disks_stop {
    DISKS_TIME,       /* time reached, or no event left */
    DISKS_COLLISIONS, /* number of collisions reached */
    DISKS_COLLAPSE    /* the clock does not advance, or disks are too
                         slow */
};

/* The next event of a disk, usually a collision with another disk or a
   wall. A partner number count + axis means a wall perpendicular to this
   axis. If a disk is its own partner, it needs a new plan, since in a
   periodic box plans have a limited range. */
struct disks_event {
    double time; /* s; INFINITY: no event */
    uint32_t disk, partner;
};

/* Disks in a box from 0 to box[k] along axis k. The members above the
   dashed line may be read, and may be written before the first run. */
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
    double impulse[DISKS_AXES]; /* on the two walls of each axis, N s */
    double virial;              /* sum of distance times impulse, J s */
    uint32_t *hits;          /* collisions of each disk, including walls */
    uint64_t standing;       /* collisions at the present time */
    struct disks_plan *plan; /* private to disks_run */
};

/* Prepares count >= 1 disks in 2 or 3 dimensions. All masses and the
   restitution are 1, and all other numbers 0. Returns false, with nothing
   to free, if memory runs out. */
bool disks_create(struct disks *d, size_t dimensions, size_t count);

/* Frees the disks and makes *d empty. */
void disks_free(struct disks *d);

/* Returns the time (in s, at least 0) until a disk meets the wall toward
   which it flies, at 0 or at `length` (in m). Its centre is then a radius
   away from the wall (5.1, eq:wall-time). x is the position of the centre
   and v its velocity. Returns INFINITY if v is 0. */
double disks_wall_time(double x, double v, double radius, double length);

/* Returns the time (in s, at least 0) until the centres of two disks are
   `distance` (in m) apart (5.3, eq:pair-time). Returns 0 for two disks that
   touch or overlap and approach each other, and INFINITY for two disks that
   never meet. separation (m) and closing (m/s) are the position and
   velocity of the second disk relative to the first, with DISKS_AXES
   components. */
double disks_pair_time(const double separation[], const double closing[],
                       double distance);

/* Returns the time (in s) at which disks i and j will meet (5.10,
   eq:meeting). The result is the same to the last bit for all calls until
   one of the disks collides again. In a periodic box, uses the images that
   are nearest at the time `at` (in s), which must not be before the last
   collision of either disk. */
double disks_meeting(const struct disks *d, size_t i, size_t j, double at);

/* Returns the time (in s) at which disk i will meet its next wall, or
   INFINITY if it meets no wall. Sets *axis to the axis perpendicular to
   this wall. */
double disks_wall(const struct disks *d, size_t i, size_t *axis);

/* Returns whether event a comes before b. Events at the same time are
   ordered by the smaller number of the pair, then by the larger. */
bool disks_before(struct disks_event a, struct disks_event b);

/* Returns the earliest event of all walls and all pairs. */
struct disks_event disks_next(const struct disks *d);

/* Carries out an event: moves its disks to its time, gives them new
   velocities, and updates the clock, the counts and the sums. */
void disks_collide(struct disks *d, struct disks_event event);

/* Returns whether more than 1000 + 10 count collisions have taken place at
   the present time. The clock will then never advance again. */
bool disks_collapsed(const struct disks *d);

/* Returns whether all disks are too slow for double precision, though some
   move. With v the speed of the fastest disk, each of v^2, m v^2 and (v
   times the largest radius)^2 must be at least 2^-900; the last one is
   needed for the time of a contact. Squares keep full precision down to
   2^-970, that is for speeds 3e10 times lower, at which disks meet 3e10
   times later. With radii and masses of 1 the slowest speed is 3.5e-136
   m/s. A colder gas ends as in a collapse. Under gravity no speed is too
   slow. */
bool disks_cold(const struct disks *d);

/* Returns, after a collision of disk i, whether the run must end because of
   disks_collapsed or disks_cold. */
bool disks_over(const struct disks *d, size_t i);

/* Returns the first disk that lies at rest on the floor under gravity,
   because its bounces are shorter than the clock can resolve. Returns count
   if there is no such disk. Such a disk ends a run as a collapse does. */
size_t disks_lying(const struct disks *d);

/* Returns the distance (in m) that a disk may fly before it needs a new
   plan, since other images may then be the nearest. Returns INFINITY with
   walls. Returns 0 if the box is too narrow to be periodic: its width must
   exceed four times the largest radius by at least a few millionths. */
double disks_replan_distance(const struct disks *d);

/* Allocates the plans for disks_run, and plans from the present state. Must
   be called again whenever the caller has changed the state. Returns false
   if memory runs out. Requires disks_replan_distance(d) > 0. */
bool disks_plan(struct disks *d);

/* Runs until the time `until` (s), or until `collisions` pair collisions
   have been counted, whichever is first. Examines all disks after each
   collision, in a time proportional to count. Splitting a run into several
   calls does not affect the results. Requires disks_plan. `until` must be
   finite if the disks may never meet again, since the run would not end. */
enum disks_stop disks_run(struct disks *d, double until,
                          uint64_t collisions);

/* Fills place[DISKS_AXES] with the position (in m) of disk i at the time
   d->now (5.4, eq:disk-clock). */
void disks_position(const struct disks *d, size_t i, double place[]);

/* Fills velocity[DISKS_AXES] with the velocity (in m/s) of disk i at the
   time d->now. Only gravity changes it between collisions. */
void disks_velocity(const struct disks *d, size_t i, double velocity[]);

/* Returns the kinetic energy, J. Under gravity this includes the potential
   energy, which is 0 for disks on the floor. */
double disks_energy(const struct disks *d);

/* Fills drift[DISKS_AXES] with the velocity of the centre of mass, m/s.
   Only the components along periodic axes are computed, which no collision
   changes. The others are 0, since walls take momentum. All are 0 if the
   energy of the drift is below the last bit of the kinetic energy: such a
   drift is a rounding error. */
void disks_drift(const struct disks *d, double drift[]);

/* Return the energy of the motion relative to the drift (in J), and the
   temperature kT (in J). Under gravity the energy includes the potential
   energy. kT is 2 K / (D N - P), where K is the kinetic energy, D the
   number of dimensions and P the number of periodic axes: along each
   periodic axis N disks have only N - 1 independent relative velocities.
   Under gravity kT is that of equilibrium, 2 E / ((D + 2) N - P) (7.13,
   eq:weight-energy). kT is 0 for a single disk without walls. */
double disks_heat(const struct disks *d);
double disks_temperature(const struct disks *d);

/* Returns the packing fraction: the area (volume) of all disks divided by
   the area (volume) of the box. */
double disks_packing(const struct disks *d);

/* Return whether the box is periodic along axis k, and whether it has walls
   perpendicular to axis k. An open box has neither. */
bool disks_wraps(const struct disks *d, size_t k);
bool disks_walled(const struct disks *d, size_t k);

/* Folds a position back into the box along its periodic axes, for a table
   or a picture. During a run positions are not folded. */
void disks_fold(const struct disks *d, double place[]);

/* Fills separation with b - a, m. In a periodic box b is replaced by its
   image nearest to a (5.11, eq:image). */
void disks_separation(const struct disks *d, const double a[],
                      const double b[], double separation[]);

/* Returns whether all disks are in the box and no two overlap by more than
   1e-9 of the box or of their distance. If not, sets *a and *b to the first
   two disks that overlap, or *b to count if disk *a overlaps a wall.
   Examines every pair. */
bool disks_fit(const struct disks *d, size_t *a, size_t *b);

/* Returns whether disks a and b overlap at present by more than disks_fit
   allows. If b is count, returns whether disk a extends beyond the
   walls. */
bool disks_clash(const struct disks *d, size_t a, size_t b);

/* Place the disks, whose radii are given, on a lattice or at random. The
   lattice is close-packed (triangular or face-centred cubic): the one that
   keeps the disks farthest apart. A disk wider than all others is placed in
   the middle. Random disks are placed one after another. Return false if
   the disks do not fit. */
bool disks_place_lattice(struct disks *d);
bool disks_place_random(struct disks *d, struct random *r);

/* Give every disk the speed v in a random direction, or a random thermal
   velocity at the temperature kT. Then remove the total momentum along
   periodic axes and restore the energy. */
void disks_set_speed(struct disks *d, double v, struct random *r);
void disks_set_temperature(struct disks *d, double kT, struct random *r);

/* Moves every disk to its present position and sets the clock and all
   counts to zero, as after a warm-up. disks_plan must be called again
   afterwards. */
void disks_settle(struct disks *d);

#endif
