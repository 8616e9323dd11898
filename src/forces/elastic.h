/* Scenes of springs: oscillator, double pendulum, membrane, beam. */
#ifndef ELASTIC_H
#define ELASTIC_H

#include "scenes/gallery.h"

enum { ELASTIC_SIDE = 2048 }; /* largest side of a grid, in bodies */

/* The scenes of chapter 10 are elastic_scenes in gallery.h: oscillator,
   double-pendulum, membrane and cantilever. */

/* The parameters of a membrane. */
struct elastic_membrane {
    size_t nx, ny;    /* numbers of bodies along x, y, including the rim */
    double mass;      /* kg */
    double stiffness; /* N/m */
    double damping;   /* of the dashpots, kg/s */
    double rest;      /* rest length divided by the distance of
                         neighbours */
    double amplitude; /* of the displacement in the mode (r, s), m */
    size_t r, s;      /* numbers of half waves along x and y */
    bool free;        /* bodies may also move in the plane */
    double gravity;   /* along -z, m/s^2 */
    double friction;  /* each body feels the force -friction * v, kg/s */
};

/* Builds a membrane 2 m wide. Returns NULL, or an error message. After an
   error there is nothing to free. */
const char *elastic_membrane(struct scene *s,
                             const struct elastic_membrane *m);

#endif
