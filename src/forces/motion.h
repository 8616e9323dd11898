/* A scene in motion, with the accelerations of all its forces. */
#ifndef MOTION_H
#define MOTION_H

#include "forces/gravity.h"
#include "forces/impact.h"
#include "forces/jacobi.h"
#include "scenes/scene.h"
#include "forces/spheres.h"
#include "forces/springs.h"
#include "forces/stepping.h"
#include "forces/soft.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The motion of a scene. Before the first step a caller may change settings
   of its modules, such as the number of threads for gravity. */
struct motion {
    struct scene *scene; /* its positions and velocities are stepped */
    double dt;           /* length of the first steps, s */
    struct stepping stepping;
    struct gravity gravity; /* used if `attracts` */
    struct springs springs; /* used if `bound` */
    struct spheres spheres; /* used if `collides` */
    struct jacobi jacobi;   /* used if `orbits`: drifts along ellipses */
    struct impact impact;   /* used if `located`: finds times of contacts */
    struct soft soft;       /* used if `is_soft`: contacts as springs */
    bool attracts, bound, collides, orbits, located, is_soft;
    uint64_t collisions; /* so far, between bodies and with walls */
    size_t *held, fixed; /* held[fixed] lists the fixed coordinates */
    /* NULL, or a function that replaces the method. It moves x and v by the
       time dt (in s), and returns false if it fails. It serves integrators
       outside forces/stepping.h, such as forces/reference.h. */
    bool (*outside)(void *with, double dt, double x[], double v[]);
    void *with;
};

/* The parts of the energy, in the scene's units: kinetic, mutual gravity,
   springs (including soft contacts), and uniform gravity (weight). */
struct motion_energy {
    double kinetic, gravity, springs, weight;
};

/* The reasons why a scene cannot be stepped, explained at motion_flaw. */
enum motion_flaw {
    MOTION_WELL,
    MOTION_WALLS,
    MOTION_MASSLESS,
    MOTION_RESTITUTION,
    MOTION_POINTS,
    MOTION_THICK
};

/* Prepares to step s, which must outlive m. Sets velocities along fixed
   coordinates to zero. If dt is 0, uses the scene's step. Sums are
   compensated for methods of order six or more. On failure prints an error
   that begins with `program`, and returns false with nothing to free. */
bool motion_begin(struct motion *m, const char *program, struct scene *s,
                  const char *method, double dt);

/* Prepares m only for computing the energy of a scene that an event-driven
   engine moves. Otherwise like motion_begin, but allows bodies without
   radius that lie on one line. */
bool motion_view(struct motion *m, const char *program, struct scene *s);
void motion_end(struct motion *m);

/* Makes motion_run find contacts within the steps instead of after them.
   Must be called before the first step, for a scene with contacts, a method
   of stepping_methods and dt > 0. Returns false, with m unchanged, if
   memory runs out. */
bool motion_locate(struct motion *m);

/* Takes `steps` steps. Contacts, if the scene has any, are resolved after
   each step or within it. Dividing a run into several calls does not change
   its results. */
enum stepping_end motion_run(struct motion *m, uint64_t steps);
double motion_time(const struct motion *m); /* current time, s */

/* Sets the length of the following steps to dt (in s) and resets their
   count to 0. Returns false, with m unchanged, if memory runs out. */
bool motion_shorten(struct motion *m, double dt);

/* Sets m, before its first step, to the time of a run that began at the
   time start (in s) and has taken `steps` steps. */
void motion_resume(struct motion *m, double start, uint64_t steps);

/* Stores in the scene the time, the initial step, the rounding errors and
   the acceleration kept by the method. A run with the same method, from a
   file written by scene_write, then continues with identical bits. Returns
   false if memory runs out. */
bool motion_note(struct motion *m);

/* Return the parts of the current energy, the kinetic energy and the
   potential energy, in the units of the scene. Fixed coordinates do not
   contribute to `weight`. */
struct motion_energy motion_energy(const struct motion *m);
double motion_kinetic(const struct motion *m);
double motion_potential(const struct motion *m);

/* Returns why s cannot be stepped, or MOTION_WELL if it can.

   - MOTION_WALLS: the scene has walls but no contact.
   - MOTION_RESTITUTION: it has a restitution, but its contacts are springs,
     which have their own restitution.
   - MOTION_MASSLESS: a force acts on a body without mass.
   - MOTION_POINTS: a body without a radius shares a line with another;
     steps cannot detect their collisions.
   - MOTION_THICK: a body is wider than the box.

   The last three set *body, unless body is NULL. */
enum motion_flaw motion_flaw(const struct scene *s, size_t *body);

/* Returns the contacts that are resolved after steps, or NULL. */
const struct spheres *motion_contacts(const struct motion *m);

#endif
