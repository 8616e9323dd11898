/* Springs with dashpots between the bodies of a scene. */
#ifndef SPRINGS_H
#define SPRINGS_H

#include "scenes/scene.h"
#include "forces/stepping.h"

/* Sizes found by measurement. */
enum {
    SPRINGS_BAND = 16,     /* smallest number of springs in a band */
    SPRINGS_BLOCK = 512,   /* bodies in a block */
    SPRINGS_DEPTH = 8,     /* maximum number of steps in a sweep */
    SPRINGS_WINDOW = 8192, /* maximum number of bodies between the first and
                              the last step of a sweep */
    SPRINGS_SHARE = 10000  /* fewest bodies for which threads save time */
};

/* How the forces are summed. This does not affect the bits. */
enum springs_engine {
    SPRINGS_GATHER, /* bands of springs, block by block */
    SPRINGS_SCATTER /* springs one after another */
};

/* A band: springs of one kind that join body i to body i + stride. There
   is one for at least half of the bodies i from `first` to end - 1. */
struct springs_band {
    size_t stride, first, end;
    double stiffness, damping;
    double *rest; /* rest[i - first]: rest length of the spring at body i,
                     m; negative if there is none */
};

/* The springs of a scene. The members may be read, and engine may be set. A
   body without mass has the inverse mass 0, like a fixed body. Therefore no
   spring moves it; but gravity does, unless it is fixed. */
struct springs {
    size_t bodies, count;
    struct scene_spring *spring; /* in the order of the sums; a < b */
    struct scene_kind *kind;
    size_t listed; /* number of springs in no band; they come first */
    size_t bands;
    struct springs_band *band;
    double *inverse; /* [3 * bodies] inverse mass, 1/kg; 0 if fixed */
    double *gravity; /* [3 * bodies] uniform, m/s^2; 0 if fixed */
    double friction;
    bool quiet; /* neither gravity nor friction acts */
    bool even;  /* inverse masses are equal along all axes */
    bool axial;
    enum springs_engine engine;
    int threads;
    double *force;  /* [3 * bodies] sums made by scatter, N */
    double *buffer; /* band forces, for each thread or each step of a
                       sweep */
};

/* Prepares *p for the springs of a scene. The scene may change afterwards.
   Returns false, with nothing to free, if memory runs out. */
bool springs_create(struct springs *p, const struct scene *s);

/* Frees everything and makes *p empty. */
void springs_free(struct springs *p);

/* Adds to a[] the accelerations (in m/s^2) due to springs and dashpots. x,
   v and a are arranged axis by axis, as in struct scene. a[] does not
   change for fixed coordinates. Neither the engine nor the number of
   threads affects the bits. Source: (10.1, eq:spring-force), and (10.3,
   eq:axial-dashpot) if the scene has axial dashpots. */
void springs_add(struct springs *p, const double x[], const double v[],
                 double a[]);

/* Writes into a[] the accelerations due to springs, the scene's gravity
   and its friction, for a scene without other forces. */
void springs_accelerate(void *springs, const double x[], const double v[],
                        double a[]);

/* Returns springs_accelerate as forces for stepping_begin. */
struct stepping_forces springs_forces(struct springs *p);

/* A stepping_sweep that computes the same as springs_accelerate, for a
   struct stepping with springs_forces. */
void springs_sweep(void *springs, const double x[], const double v[],
                   double a[], const struct stepping_ahead *ahead,
                   uint64_t steps);

/* Returns the energy of all springs, J. */
double springs_potential(const struct springs *p, const double x[]);

/* Returns whether any spring has a dashpot. */
bool springs_damped(const struct springs *p);

/* Sets the number of threads, 1 or more, that share the work from now on.
   Returns false, with nothing changed, if memory runs out. */
bool springs_threads(struct springs *p, int threads);

#endif
