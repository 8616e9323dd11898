/* From chapters/09-gravity.nw: edit there, then run make tangle. */
/* checksum 1616757755 of the lines below */
/* Gravity between all pairs of bodies, with softening. */
#ifndef GRAVITY_H
#define GRAVITY_H

#include "forces/stepping.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* How the sum is computed. All but the tree sum in the same order; that
   for AVX-512 rounds otherwise, by less than 1e-14 of each term. */
enum gravity_kernel {
    GRAVITY_AUTO,         /* the fastest that keeps the bits: portable */
    GRAVITY_PORTABLE,     /* plain C, the same bits everywhere */
    GRAVITY_AVX512,       /* by hand, eight bodies at a time */
    GRAVITY_TREE,         /* far groups as one mass: not unplanted */
    GRAVITY_OPENCL,       /* on a device: not without `elsewhere' */
    GRAVITY_OPENCL_FLOAT, /* in single precision */
    GRAVITY_KERNELS
};

/* Their names, as an option takes them; ends with NULL. */
extern const char *const gravity_kernels[];

enum {
    GRAVITY_FEW = 32,    /* bodies up to which a pair is taken once */
    GRAVITY_SHARE = 1000 /* from which to share them among threads pays */
};

/* What pulls. Coordinate k of body i stands at [k * bodies + i]. */
struct gravity {
    size_t bodies;
    const double *mass;         /* [bodies], of the caller */
    double k2;                  /* acceleration times distance squared, of
                                   the mass 1 */
    double softening;           /* m; 0: none */
    enum gravity_kernel kernel; /* more than a few bodies: who sums */
    int threads;                /* and in how many threads */
    const uint32_t *source;     /* NULL, or which bodies pull: no others */
    size_t sources;             /* how many they are */
    const double *share;        /* [bodies] if there are sources: a factor
                                   on all that pulls at a body */
    struct gravity_tree *tree;  /* NULL, or what GRAVITY_TREE works in */
    /* NULL, or what sums in place of a kernel, all bodies at a time. */
    void (*elsewhere)(void *device, const double x[], double a[]);
    void *device;
};

/* The widest cell, seen from a distance of 1, that may be taken for one
   mass: up to 1/sqrt(3) no body is in a cell that it takes so. */
#define GRAVITY_WIDEST 0.57

/* Prepares the sum over so many bodies: the kernel auto, one thread.
   mass is kept, not copied. Returns false, with nothing to free, when
   there is no memory. */
bool gravity_create(struct gravity *g, size_t bodies, const double mass[],
                    double k2, double softening);

/* Chooses the kernel tree, which takes a cell for one mass if its width is
   less than theta times its distance, 0 to GRAVITY_WIDEST. Returns false,
   with nothing changed, when there is no memory. */
bool gravity_plant(struct gravity *g, double theta);

/* Frees what gravity_create and gravity_plant took. */
void gravity_free(struct gravity *g);

/* Adds to a[] the accelerations of bodies at x[], both of 3 * bodies
   numbers, axis by axis. Without softening, bodies in one place make NaN.
   The same bits for every number of threads. Source: (9.2,
   eq:softened-force). */
void gravity_add(const struct gravity *g, const double x[], double a[]);

/* The same for stepping_begin: writes a. g must outlive them. */
struct stepping_forces gravity_forces(struct gravity *g);

/* The potential energy, mass 1 times velocity squared. Source: (9.1,
   eq:softened-potential). */
double gravity_potential(const struct gravity *g, const double x[]);

/* Says whether this machine, and this build, has the kernel itself, not
   on a device; which of those that it has is the fastest. */
bool gravity_can(enum gravity_kernel kernel);
enum gravity_kernel gravity_fastest(void);

/* Returns what sums: "pairs", "sources", or the name of the kernel. */
const char *gravity_summed_by(const struct gravity *g);

#endif
