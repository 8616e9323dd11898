/* Springs with dashpots between the bodies of a scene. */
#ifndef SPRINGS_H
#define SPRINGS_H

#include "scenes/scene.h"
#include "forces/stepping.h"

/* Found by trying. */
enum {
    SPRINGS_BAND = 16,     /* springs that a band has at least */
    SPRINGS_BLOCK = 512,   /* bodies at a time */
    SPRINGS_DEPTH = 8,     /* steps of a sweep, at most */
    SPRINGS_WINDOW = 8192, /* bodies between its first and its last step */
    SPRINGS_SHARE = 10000  /* from which to share them among threads pays */
};

/* How the forces are summed. Both ways give the same bits. */
enum springs_engine {
    SPRINGS_GATHER, /* bands of springs, block by block */
    SPRINGS_SCATTER /* spring after spring */
};

/* Springs that join body i to body i + stride, all of one kind, for many of
   the bodies i from first on, before end. */
struct springs_band {
    size_t stride, first, end;
    double stiffness, damping;
    double *rest; /* of the spring at body i: rest[i - first], m; negative
                     where there is none */
};

/* The springs of a scene. To be read; engine may be written. A body without
   mass has the inverse 0, as one that is held: no spring moves it. Gravity
   does, wherever it is free, which takes no mass. */
struct springs {
    size_t bodies, count;
    struct scene_spring *spring; /* in the order of the sums; a < b */
    struct scene_kind *kind;
    size_t listed; /* number of springs in no band: the first ones */
    size_t bands;
    struct springs_band *band;
    double *inverse; /* [3 * bodies] of the mass; 0 where it is held */
    double *gravity; /* [3 * bodies] the scene's, m/s^2; 0 where held */
    double friction;
    bool quiet; /* there is neither gravity nor friction */
    bool even;  /* inverse masses are the same along all axes */
    bool axial;
    enum springs_engine engine;
    int threads;
    double *force; /* [3 * bodies] what is summed spring by spring */
    double
        *buffer; /* forces of bands, for each thread or step of a sweep */
};

/* Takes what it needs of the scene, which may change or go away after it.
   Returns false, with nothing to free, when there is no memory. */
bool springs_create(struct springs *p, const struct scene *s);

/* Frees all and makes *p empty. */
void springs_free(struct springs *p);

/* Adds to a what the springs and their dashpots do to the bodies, m/s^2.
   x, v and a lie axis by axis, as in struct scene. Along a fixed coordinate
   a stays as it is. The same bits from either engine and from any number of
   threads. Source: (10.1, eq:spring-force), and (10.3, eq:axial-dashpot) if
   the scene says so. */
void springs_add(struct springs *p, const double x[], const double v[],
                 double a[]);

/* Writes into a what the springs, the scene's gravity and its friction do,
   for a scene in which nothing else acts: such a scene may be swept, too.
 */
void springs_accelerate(void *springs, const double x[], const double v[],
                        double a[]);

/* Returns springs_accelerate in the form that stepping_begin needs. */
struct stepping_forces springs_forces(struct springs *p);

/* Does what springs_accelerate does in one sweep, for the stepping that has
   springs_forces; see stepping_sweep. */
void springs_sweep(void *springs, const double x[], const double v[],
                   double a[], const struct stepping_ahead *ahead,
                   uint64_t steps);

/* Returns the energy of all springs, J. */
double springs_potential(const struct springs *p, const double x[]);

/* Returns whether any spring has a dashpot. */
bool springs_damped(const struct springs *p);

/* Sets how many threads share the work from now on, 1 or more. Returns
   false when there is no memory: then all is as it was. */
bool springs_threads(struct springs *p, int threads);

#endif
