/* A scene set in motion by all that acts in it, as one acceleration. */
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

/* A scene set in motion: all that acts in it, as one acceleration. The
   parts are open to the caller: who wants two threads for gravity or other
   sums says so to the part, before the first step. */
struct motion {
    struct scene *scene; /* position and velocity are stepped in place */
    double dt;           /* s, of the steps that it begins with */
    struct stepping stepping;
    struct gravity gravity; /* if attracts */
    struct springs springs; /* if bound */
    struct spheres spheres; /* if collides */
    struct jacobi jacobi;   /* if orbits: the method wants ellipses */
    struct impact impact;   /* if located: finds the moments of contacts */
    struct soft soft;       /* if is_soft: contacts are springs */
    bool attracts, bound, collides, orbits, located, is_soft;
    uint64_t collisions; /* of pairs and with walls, so far */
    size_t *held, fixed; /* coordinates that stay: how many */
    /* NULL, or what steps in place of the method, from x, v to those dt
       later; returns false if it cannot. For a stepper that is none of
       ours, such as forces/reference.h. */
    bool (*outside)(void *with, double dt, double x[], double v[]);
    void *with;
};

/* Where the energy is, J in the units of the scene. */
struct motion_energy {
    double kinetic, gravity, springs, weight;
};

/* What makes it impossible to step a scene. */
enum motion_flaw {
    MOTION_WELL,
    MOTION_WALLS,
    MOTION_MASSLESS,
    MOTION_RESTITUTION,
    MOTION_POINTS,
    MOTION_THICK
};

/* Prepares to step s, which has to outlive m; velocities along held
   coordinates become zero. A dt of 0 is the scene's. Sums are compensated
   from order six on. On failure says why on standard error, after program,
   and returns false with nothing to free. */
bool motion_begin(struct motion *m, const char *program, struct scene *s,
                  const char *method, double dt);

/* Prepares m, as motion_begin does, for a scene that an event-driven engine
   moves: m then gives only its energy. Points may be on one line. */
bool motion_view(struct motion *m, const char *program, struct scene *s);
void motion_end(struct motion *m);

/* From here on contacts are found inside the steps, and not after them.
   Before the first step, of a scene that has contacts, by a method of our
   own and dt > 0. Returns false, with m as it was, if memory runs out. */
bool motion_locate(struct motion *m);

/* Takes `steps` steps. Contacts, if the scene has any, are resolved after
   each step or within it. The number of calls into which a run is divided
   does not affect the results. */
enum stepping_end motion_run(struct motion *m, uint64_t steps);
double motion_time(const struct motion *m); /* s */

/* From here on a step is dt long, s, and the steps are counted from 0.
   Returns false, with m as it was, if memory runs out. */
bool motion_shorten(struct motion *m, double dt);

/* Takes m, before its first step, for a run that began at the time start,
   s, and has taken `steps` steps. */
void motion_resume(struct motion *m, double start, uint64_t steps);

/* Puts time, step (that of the beginning), rounding errors and the
   acceleration that the method has kept into the scene: what scene_write
   then writes goes on, by the same method, to the same bits. Returns false
   if memory runs out. */
bool motion_note(struct motion *m);

/* The energy now. Held coordinates have no weight. */
struct motion_energy motion_energy(const struct motion *m);
double motion_kinetic(const struct motion *m);
double motion_potential(const struct motion *m);

/* Says whether s can be stepped: MOTION_WALLS if it has walls but no
   contact, MOTION_RESTITUTION if it has a restitution but contacts that are
   springs, which have their own. For the others a number goes to body,
   which may be NULL: MOTION_MASSLESS if a force acts on a body without
   mass; MOTION_POINTS if a body without a radius shares a line with another
   one, which steps let pass, since a distance never goes below 0;
   MOTION_THICK if a body is thicker than the box. */
enum motion_flaw motion_flaw(const struct scene *s, size_t *body);

/* The contacts that are looked for after steps, or NULL. */
const struct spheres *motion_contacts(const struct motion *m);

#endif
