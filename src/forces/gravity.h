/* Gravity between all pairs of bodies, with softening. */
#ifndef GRAVITY_H
#define GRAVITY_H

#include "forces/stepping.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Ways to sum the accelerations of more than GRAVITY_FEW bodies. All but
   the tree add in one order; AVX-512 rounds differently, by less than 1e-14
   of each term. */
enum gravity_kernel {
    GRAVITY_AUTO,         /* the fastest with the bits of portable */
    GRAVITY_PORTABLE,     /* plain C, equal bits on every machine */
    GRAVITY_AVX512,       /* by intrinsics, eight bodies at a time */
    GRAVITY_TREE,         /* Barnes and Hut's: needs gravity_use_tree */
    GRAVITY_OPENCL,       /* on a device: needs `elsewhere` */
    GRAVITY_OPENCL_FLOAT, /* that in single precision */
    GRAVITY_KERNELS
};

/* The names of the kernels, as an option takes them; ends with NULL. */
extern const char *const gravity_kernels[];

enum {
    GRAVITY_FEW = 32,   /* most bodies for which pairs are summed once */
    GRAVITY_MANY = 1000 /* fewest bodies for which threads pay */
};

struct tree;

/* Bodies that attract each other. Coordinate k of body i is element [k *
   bodies + i] of an array. */
struct gravity {
    size_t bodies;
    const double *mass;         /* [bodies], the caller's */
    double k2;                  /* acceleration times distance^2, mass 1 */
    double softening;           /* m; 0: none */
    enum gravity_kernel kernel; /* for more than GRAVITY_FEW bodies */
    int threads;                /* number of threads */
    const uint32_t *source;     /* NULL, or [sources]: only these bodies
                                   attract */
    size_t sources;
    const double *factor; /* [bodies] with sources: of accelerations */
    struct tree *tree;    /* NULL, or the tree of GRAVITY_TREE */
    /* NULL, or a function that replaces the kernel */
    void (*elsewhere)(void *device, const double x[], double a[]);
    void *device;
};

/* The largest ratio theta of a cell's width to its distance for which the
   cell may count as one mass: below 1/sqrt(3) no such cell contains the
   body itself. */
#define GRAVITY_WIDEST 0.57

/* Prepares the sum over `bodies` bodies, with the kernel auto and one
   thread. The pointer mass is kept. Returns true: it needs no memory. */
bool gravity_create(struct gravity *g, size_t bodies, const double mass[],
                    double k2, double softening);

/* Chooses the tree as the kernel, which treats a cell as one mass if its
   width is less than theta times its distance; theta is 0 to
   GRAVITY_WIDEST. Returns false, with nothing changed, if memory runs
   out. */
bool gravity_use_tree(struct gravity *g, double theta);

/* Frees what gravity_create and gravity_use_tree allocated. */
void gravity_free(struct gravity *g);

/* Adds to a[] the accelerations of bodies at x[], both of 3 * bodies
   numbers, axis by axis: (9.2, eq:softened-force). Without softening, two
   bodies at one place give NaN. The number of threads changes no bits. */
void gravity_add(const struct gravity *g, const double x[], double a[]);

/* Returns gravity_add as forces for stepping_begin; g must outlive them. */
struct stepping_forces gravity_forces(struct gravity *g);

/* Returns the potential energy, in units of mass 1 times velocity squared:
   (9.1, eq:softened-potential). */
double gravity_potential(const struct gravity *g, const double x[]);

/* Return whether this build on this machine has this kernel, devices
   excluded; and the fastest of all kernels that it has, which may round
   differently from GRAVITY_AUTO. */
bool gravity_can(enum gravity_kernel kernel);
enum gravity_kernel gravity_fastest(void);

/* Returns how accelerations are summed: "pairs", "sources", or a kernel. */
const char *gravity_summed_by(const struct gravity *g);

#endif
