/* Gravity between all pairs of bodies, with softening. */
#ifndef GRAVITY_H
#define GRAVITY_H

#include "forces/stepping.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Ways to sum the accelerations of more than GRAVITY_FEW bodies. All but
   the tree add the terms in the same order. AVX-512 rounds differently, by
   less than 1e-14 of each term. */
enum gravity_kernel {
    GRAVITY_AUTO,         /* fastest kernel bit-identical to portable */
    GRAVITY_PORTABLE,     /* plain C; bit-identical on all machines */
    GRAVITY_AVX512,       /* intrinsics, for eight bodies at once */
    GRAVITY_TREE,         /* Barnes-Hut tree; needs gravity_use_tree */
    GRAVITY_OPENCL,       /* on an OpenCL device; needs `elsewhere` */
    GRAVITY_OPENCL_FLOAT, /* on an OpenCL device, in single precision */
    GRAVITY_KERNELS
};

/* The names of the kernels as option values, followed by NULL. */
extern const char *const gravity_kernels[];

enum {
    GRAVITY_FEW = 32,   /* largest number of bodies for which each pair is
                           computed only once */
    GRAVITY_MANY = 1000 /* fewest bodies for which threads save time */
};

struct tree;

/* Bodies that attract each other. In arrays, coordinate k of body i has the
   index k * bodies + i. */
struct gravity {
    size_t bodies;
    const double *mass; /* [bodies], owned by the caller */
    double k2; /* acceleration due to mass 1, times squared distance */
    double softening;           /* m; 0: none */
    enum gravity_kernel kernel; /* for more than GRAVITY_FEW bodies */
    int threads;
    const uint32_t *source; /* NULL, or [sources]: only these bodies
                               attract */
    size_t sources;
    const double *factor; /* [bodies] if source is not NULL: factors by
                             which the accelerations are multiplied */
    struct tree *tree;    /* NULL, or the tree of GRAVITY_TREE */
    /* NULL, or a function that replaces the kernel */
    void (*elsewhere)(void *device, const double x[], double a[]);
    void *device;
};

/* The largest ratio theta of a cell's width to its distance at which the
   cell may be treated as one mass. It is below 1/sqrt(3), so no such cell
   contains the attracted body. */
#define GRAVITY_WIDEST 0.57

/* Prepares the sum over `bodies` bodies, with the kernel GRAVITY_AUTO and
   one thread. The pointer mass is kept. Always returns true. */
bool gravity_create(struct gravity *g, size_t bodies, const double mass[],
                    double k2, double softening);

/* Chooses the tree as the kernel. The tree treats a cell as one mass if the
   cell's width is less than theta times its distance. theta must be from 0
   to GRAVITY_WIDEST. Returns false, with nothing changed, if memory runs
   out. */
bool gravity_use_tree(struct gravity *g, double theta);

/* Frees what gravity_create and gravity_use_tree allocated. */
void gravity_free(struct gravity *g);

/* Adds to a[] the accelerations of bodies at the positions x[]: (9.2,
   eq:softened-force). Both arrays have 3 * bodies numbers, axis by axis.
   Without softening, two bodies at the same position give NaN. The result
   is bit-identical for any number of threads. */
void gravity_add(const struct gravity *g, const double x[], double a[]);

/* Returns gravity_add as forces for stepping_begin; g must outlive them. */
struct stepping_forces gravity_forces(struct gravity *g);

/* Returns the potential energy, in units of mass times velocity squared:
   (9.1, eq:softened-potential). */
double gravity_potential(const struct gravity *g, const double x[]);

/* Returns whether this build has the kernel and this machine can run it.
   Returns false for the kernels of devices. */
bool gravity_can(enum gravity_kernel kernel);

/* Returns the fastest kernel for this machine, devices and tree excluded.
   It may round differently from GRAVITY_AUTO. */
enum gravity_kernel gravity_fastest(void);

/* Returns how accelerations are summed: "pairs", "sources", or a kernel. */
const char *gravity_summed_by(const struct gravity *g);

#endif
