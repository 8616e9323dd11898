/* Light bodies as test particles, attracted only by inner bodies. */
#ifndef PARTICLES_H
#define PARTICLES_H

#include "forces/jacobi.h"
#include "scenes/scene.h"

/* A body with a sorting key: a coordinate or a squared distance. */
struct particles_place {
    double key; /* m, or m^2 */
    size_t body;
};

/* Heavy bodies, and light bodies that are test particles. A light
   body is attracted only by the heavy bodies and by inner light bodies. */
struct particles {
    size_t bodies, heavy;
    uint32_t *order; /* [bodies] heavy bodies by number, then light bodies
                        from the inside outwards */
    double *factor;  /* [bodies] factor of each acceleration */
    bool moving;     /* all bodies are free, and only gravity acts */
    /* All heavy bodies as a single body, then the light bodies. The light
       bodies have no mass unless `moving`. */
    struct jacobi jacobi;
    double *mass, *work;       /* [n], [6 * n]; n: jacobi.bodies */
    double centre[SCENE_AXES]; /* centre of mass at the start, m */
    double drift[SCENE_AXES];  /* velocity of the centre of mass, m/s */
};

/* Compares two struct particles_place for qsort: by key, then by number. */
int particles_compare(const void *one, const void *other);

/* Returns whether body i has less than a hundredth of the mass
   `heaviest`. */
bool particles_is_light(const struct scene *s, size_t i, double heaviest);

/* Divides the bodies of s into heavy and light bodies, and sorts the light
   ones. Body `centre` is heavy, and so are all bodies with at least a
   hundredth of the mass `heaviest`. There must be at least one heavy body.
   `moving` must be false if a body is fixed or a force other than gravity
   acts. Returns false, with nothing to free, if memory runs out. */
bool particles_create(struct particles *l, const struct scene *s,
                      double heaviest, size_t centre, bool moving);
void particles_free(struct particles *l);

/* Copies positions or velocities x, arranged as in a scene, to q in the
   order of l->jacobi: first the centre of mass of the heavy bodies, then
   the light bodies. */
void particles_gather(const struct particles *l, const struct scene *s,
                      const double x[], double q[]);

/* Converts positions x and velocities v of the light bodies, arranged as in
   a scene, to Jacobi coordinates: relative to the centre of mass of all
   bodies further in, plus the position or velocity of the centre of mass of
   the heavy bodies. Source: (12.2, eq:light-jacobi). */
void particles_to_jacobi(struct particles *l, const struct scene *s,
                         double x[], double v[]);

/* Reverses particles_to_jacobi after the time t (s). Takes into account
   that the centre of mass of all bodies has moved. */
void particles_from_jacobi(const struct particles *l, const struct scene *s,
                           double t, double x[], double v[]);

#endif
