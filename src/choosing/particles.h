/* Light bodies as test particles, each alone with all that is inside it. */
#ifndef PARTICLES_H
#define PARTICLES_H

#include "forces/jacobi.h"
#include "scenes/scene.h"

/* A body in an order, by where it is or how far away. */
struct particles_place {
    double key; /* m, or m^2 */
    size_t body;
};

/* Heavy bodies, and light ones as test particles: each light one moves as
   if only the heavy ones and the light ones nearer to them existed. */
struct particles {
    size_t bodies, heavy;
    uint32_t *order; /* [bodies] the heavy ones, by number; then the light
                        ones, from the nearest to the farthest */
    double *factor;  /* [bodies] by which what pulls a body is multiplied */
    bool moving;     /* the heavy ones give way */
    /* The heavy ones as one, and the light ones; massless unless moving. */
    struct jacobi jacobi;
    double *mass, *work;       /* [their number], [6 times that] */
    double centre[SCENE_AXES]; /* of all the mass at the start, m */
    double drift[SCENE_AXES];  /* its velocity, m/s */
};

/* Two places for qsort, by key; those that are equal by number. */
int particles_compare(const void *one, const void *other);

/* Is body i light, that is, has it less than a hundredth of this mass? */
bool particles_is_light(const struct scene *s, size_t i, double heaviest);

/* Sorts the bodies of s: those pull that are not light beside the heaviest,
   and the centre; there must be one. moving: none is held and nothing but
   gravity and weight acts. Returns false, with nothing to free, when there
   is no memory. */
bool particles_create(struct particles *l, const struct scene *s,
                      double heaviest, size_t centre, bool moving);
void particles_free(struct particles *l);

/* Writes places or velocities, as in a scene, in the order of the jacobi:
   those of the centre of the heavy ones first. */
void particles_gather(const struct particles *l, const struct scene *s,
                      const double x[], double q[]);

/* Replaces places and velocities of the lights (as in a scene) by those
   relative to the centre of what is inside them, plus the centre of the
   heavy ones. Source: (12.2, eq:light-jacobi). */
void particles_to_jacobi(struct particles *l, const struct scene *s,
                         double x[], double v[]);

/* The way back, a time t after that, s; the centre has gone on moving. */
void particles_from_jacobi(const struct particles *l, const struct scene *s,
                           double t, double x[], double v[]);

#endif
