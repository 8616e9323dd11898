/* Light bodies as test particles, attracted only by bodies further in. */
#ifndef PARTICLES_H
#define PARTICLES_H

#include "forces/jacobi.h"
#include "scenes/scene.h"

/* A body with a sorting key: a coordinate or a squared distance. */
struct particles_place {
    double key; /* m, or m^2 */
    size_t body;
};

/* Heavy bodies, and light ones as test particles: each light body moves as
   if only the heavy bodies and the light ones closer to these existed. */
struct particles {
    size_t bodies, heavy;
    uint32_t *order; /* [bodies] heavy bodies by number, then light ones
                        from the inside outwards */
    double *factor;  /* [bodies] factor on each acceleration */
    bool moving;     /* whether the heavy bodies move */
    /* The heavy bodies as one body, then the light ones, which have no mass
       unless moving. */
    struct jacobi jacobi;
    double *mass, *work;       /* [n], [6 * n]; n: bodies of jacobi */
    double centre[SCENE_AXES]; /* centre of mass at the start, m */
    double drift[SCENE_AXES];  /* velocity of the centre of mass, m/s */
};

/* Compares two struct particles_place for qsort: by key, then by number. */
int particles_compare(const void *one, const void *other);

/* Returns whether body i has less than a hundredth of the mass
   `heaviest`. */
bool particles_is_light(const struct scene *s, size_t i, double heaviest);

/* Divides the bodies of s into heavy and light ones, and sorts the light
   ones. Heavy are body `centre` and all with at least a hundredth of the
   mass `heaviest`; there must be one. moving: no body is fixed and only
   gravity acts. Returns false, with nothing to free, if memory runs out. */
bool particles_create(struct particles *l, const struct scene *s,
                      double heaviest, size_t centre, bool moving);
void particles_free(struct particles *l);

/* Copies positions or velocities x, arranged as in a scene, to q in the
   order of jacobi: first the centre of mass of the heavy bodies, then the
   light bodies. */
void particles_gather(const struct particles *l, const struct scene *s,
                      const double x[], double q[]);

/* Replaces positions and velocities of the light bodies, arranged as in a
   scene, by those relative to the centre of mass of all bodies further in;
   that of the heavy bodies is added. Source: (12.2, eq:light-jacobi). */
void particles_to_jacobi(struct particles *l, const struct scene *s,
                         double x[], double v[]);

/* Reverses particles_to_jacobi after the time t, s, in which the centre of
   mass of all bodies has moved on. */
void particles_from_jacobi(const struct particles *l, const struct scene *s,
                           double t, double x[], double v[]);

#endif
