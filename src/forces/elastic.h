/* Scenes of springs: oscillator, double pendulum, membrane, beam. */
#ifndef ELASTIC_H
#define ELASTIC_H

#include "scenes/gallery.h"

enum { ELASTIC_SIDE = 2048 }; /* bodies on a side of a grid, at most */

/* The scenes of chapter 10: oscillator, double-pendulum, membrane,
   cantilever; elastic_scenes itself is in gallery.h. */

/* What a membrane is made of. */
struct elastic_membrane {
    size_t nx, ny;    /* bodies, the rim included */
    double mass;      /* kg */
    double stiffness; /* N/m */
    double damping;   /* of the dashpots, kg/s */
    double rest;      /* rest length over the distance of neighbours */
    double amplitude; /* of the displacement, m, in the mode (r, s) */
    size_t r, s;      /* half waves */
    bool free;        /* the bodies may move in the plane, too */
    double gravity;   /* along -z, m/s^2 */
    double friction;  /* kg/s */
};

/* Makes it, 2 m wide; returns as the build of a gallery_scene does. */
const char *elastic_membrane(struct scene *s,
                             const struct elastic_membrane *m);

#endif
