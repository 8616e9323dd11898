/* From chapters/works/12-models-parts.nw: edit there, then run make tangle. */
/* checksum 107439821 of the lines below */
/* Light bodies that do not pull, each alone with all that is inside it. */
#ifndef LIGHT_H
#define LIGHT_H

#include "scenes/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A body in an order, by where it is or how far away. */
struct light_place {
    double key; /* m, or m^2 */
    size_t body;
};

/* Bodies that pull, and light ones, which only are pulled: each one as if
   it were alone with all that is nearer to the heavy ones. */
struct light {
    size_t bodies, heavy, lights;
    uint32_t *source; /* [heavy] which they are, rising */
    uint32_t *order;  /* [lights] from the nearest to the farthest */
    double *share; /* [bodies] by which what pulls a body is multiplied */
    double *inner; /* [lights] mass of the heavy ones and of the lights up
                      to and including this one, kg */
    bool moving;   /* the heavy ones give way: Jacobi's coordinates */
    double centre[SCENE_AXES]; /* of all the mass at the start, m */
    double drift[SCENE_AXES];  /* its velocity, m/s */
    double fall[SCENE_AXES];   /* its acceleration, m/s^2 */
};

/* Two places for qsort, by key; those that are equal by number. */
int light_compare(const void *one, const void *other);

/* Sorts the bodies of s: is_heavy[i] says which pull; one must. moving:
   none is held and nothing but gravity and weight acts. Returns
   false, with nothing to free, when there is no memory. */
bool light_create(struct light *l, const struct scene *s,
                  const bool is_heavy[], bool moving);
void light_free(struct light *l);

/* Replaces places and velocities of the lights (as in a scene) by those
   relative to the centre of what is inside them, plus the centre of the
   heavy ones. Source: (12.2, eq:light-jacobi). */
void light_enter(const struct light *l, const struct scene *s, double x[],
                 double v[]);

/* The way back, a time t after light_create, s: the heavy ones get back the
   motion of their centre, too. */
void light_leave(const struct light *l, const struct scene *s, double t,
                 double x[], double v[]);

#endif
