/* Defines scenes: bodies, springs, walls, and what acts on them. */
#ifndef SCENE_H
#define SCENE_H

#include "toolbox/table.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { SCENE_AXES = 3 };
enum scene_wall { SCENE_OPEN, SCENE_HARD, SCENE_PERIODIC };
/* The laws of contacts. Hard bodies change their velocities at once. Soft
   bodies act on each other as linear springs or by Hertz's law. */
enum scene_law { SCENE_SUDDEN, SCENE_LINEAR, SCENE_HERTZ };

/* A kind of spring, described by a line "s". */
struct scene_kind {
    double stiffness;          /* D, N/m */
    double damping;            /* c, kg/s */
    double colour[SCENE_AXES]; /* red, green, blue, from 0 to 1 */
};

/* A spring between two bodies, described by a line "sl". */
struct scene_spring {
    uint32_t a, b, kind; /* numbers of the bodies and of the kind */
    double rest;         /* rest length, m */
};

/* The bodies, their state, and what acts on them. Arrays with three numbers
   per body are ordered by axis: coordinate k of body i is at [k * bodies +
   i]. So a method can treat all coordinates as one long array, and loops
   over bodies read memory sequentially. */
struct scene {
    size_t bodies, kinds, springs;
    double *mass, *charge, *radius; /* [bodies] kg, no unit, m */
    double *position, *velocity;    /* [3 * bodies] m, m/s */
    unsigned char *freedom;         /* [3 * bodies] 1: free, 0: fixed */
    double *colour;                 /* [3 * bodies] red, green, blue */
    uint32_t *species;              /* [bodies] */
    double *carry; /* NULL, or [6 * bodies]: remainders of the compensated
                      sums for the positions, then for the velocities */
    double *kept;  /* NULL, or [3 * bodies]: accelerations, m/s^2, with
                      which a method continues from this state */
    struct scene_kind *kind;
    struct scene_spring *spring;
    double k2;        /* strength of gravity between bodies; 0: none */
    double softening; /* softening length of gravity, m */
    double gravity[SCENE_AXES]; /* uniform acceleration, m/s^2 */
    double damping;  /* kg/s; each body feels the force -damping * v */
    double dt, time; /* time step (0: not given), time of the state, s */
    bool axial;      /* dashpots act along their spring only */
    bool contact;    /* bodies collide; if not, radii are for drawing */
    double restitution;
    enum scene_law law;
    double stiffness, /* of contacts, N/m (Hertz: N/m^1.5) */
        dashpot;      /* damping of contacts, kg/s */
    enum scene_wall wall[SCENE_AXES];
    double low[SCENE_AXES], high[SCENE_AXES]; /* ends of the box, m */
};

/* The first error in the text of a scene. */
struct scene_error {
    size_t line;    /* number of the line, from 1 */
    char text[240]; /* "found this, expected that" */
};

/* Creates a scene of `bodies` free bodies of mass 1, at rest at the origin
   between open walls, with restitution 1. Everything else is 0. Returns
   false, with nothing to free, if memory runs out. */
bool scene_create(struct scene *s, size_t bodies);

/* Frees the scene and makes *s empty. */
void scene_free(struct scene *s);

/* Makes *to a copy of the scene. Returns false, with nothing to free, if
   memory runs out. */
bool scene_copy(struct scene *to, const struct scene *from);

/* Copies positions and velocities from a scene with the same number of
   bodies. */
void scene_take_state(struct scene *s, const struct scene *from);

/* Adds a kind of spring, which gets the number s->kinds - 1. Returns false
   if memory runs out. */
bool scene_add_kind(struct scene *s, double stiffness, double damping);

/* Adds a spring between two bodies. If rest < 0, its rest length is their
   present distance. Returns false if memory runs out. */
bool scene_add_spring(struct scene *s, size_t a, size_t b, size_t kind,
                      double rest);

/* Reads a scene from a file; "-" is standard input. On failure prints why
   on standard error, as "program: file:line: found ..., expected ...", and
   returns false, with nothing to free. */
bool scene_read(struct scene *s, const char *program, const char *path);

/* Reads a scene from a text in memory, which needs no '\0' at its end. On
   failure fills *e and returns false, with nothing to free. */
bool scene_parse(struct scene *s, const char *text, size_t length,
                 struct scene_error *e);

/* Writes the scene with its present state, each rest length, the time,
   `carry` and `kept`. No number is rounded, so that a run continued from
   the file is bit-identical to an uninterrupted one. */
void scene_write(const struct scene *s, struct table *out);

#endif
