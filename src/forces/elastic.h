/* Scenes of springs: oscillator, double pendulum, membrane, beam. */
#ifndef ELASTIC_H
#define ELASTIC_H

#include "scenes/gallery.h"

enum { ELASTIC_SIDE = 2048 }; /* most bodies on a side of a grid */

/* The scenes of chapter 10: oscillator, double-pendulum, membrane,
   cantilever; elastic_scenes itself is in gallery.h. */

/* The parameters of a membrane. */
struct elastic_membrane {
    size_t nx, ny;    /* numbers of bodies, rim included */
    double mass;      /* kg */
    double stiffness; /* N/m */
    double damping;   /* of the dashpots, kg/s */
    double rest;      /* rest length over distance of neighbours */
    double amplitude; /* displacement, m, in the mode (r, s) */
    size_t r, s;      /* numbers of half waves along x and y */
    bool free;        /* bodies may also move in the plane */
    double gravity;   /* along -z, m/s^2 */
    double friction;  /* kg/s */
};

/* Builds the membrane, 2 m wide; returns NULL or an error message, like
   build of a gallery_scene. */
const char *elastic_membrane(struct scene *s,
                             const struct elastic_membrane *m);

#endif
