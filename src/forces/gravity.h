/* Gravity between all pairs of bodies, with softening. */
#ifndef GRAVITY_H
#define GRAVITY_H

#include "forces/stepping.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* How the accelerations of more than GRAVITY_FEW bodies are summed. All but
   the tree add in the same order; AVX-512 rounds otherwise, by less than
   1e-14 of each term. */
enum gravity_kernel {
    GRAVITY_AUTO,     /* the fastest that keeps the bits: portable */
    GRAVITY_PORTABLE, /* plain C, the same bits everywhere */
    GRAVITY_AVX512,   /* intrinsics, eight bodies at a time */
    GRAVITY_TREE,     /* Barnes and Hut's: call gravity_use_tree first */
    GRAVITY_OPENCL,   /* on a device: set `elsewhere' first */
    GRAVITY_OPENCL_FLOAT, /* the same in single precision */
    GRAVITY_KERNELS
};

/* The names of the kernels, as an option takes them; ends with NULL. */
extern const char *const gravity_kernels[];

enum {
    GRAVITY_FEW = 32,   /* bodies up to which a pair is taken once */
    GRAVITY_MANY = 1000 /* bodies from which several threads pay */
};

struct tree;

/* Bodies that attract each other. Coordinate k of body i stands at
   [k * bodies + i]. */
struct gravity {
    size_t bodies;
    const double *mass;         /* [bodies], of the caller */
    double k2;                  /* acceleration times distance squared, of
                                   the mass 1 */
    double softening;           /* m; 0: none */
    enum gravity_kernel kernel; /* of more than GRAVITY_FEW bodies */
    int threads;                /* which the kernel uses */
    const uint32_t *source;     /* NULL: all bodies pull; or [sources] the
                                   numbers of those that do */
    size_t sources;
    const double *factor; /* [bodies] if there are sources: a factor on the
                            acceleration of each body */
    struct tree *tree;    /* NULL, or the tree of GRAVITY_TREE */
    /* NULL, or what computes the sum of all bodies instead of a kernel. */
    void (*elsewhere)(void *device, const double x[], double a[]);
    void *device;
};

/* The largest ratio of width to distance at which a cell may be taken for
   one mass: below 1/sqrt(3) no body meets itself in such a cell. */
#define GRAVITY_WIDEST 0.57

/* Prepares the sum over `bodies` bodies, with the kernel auto and in one
   thread. The pointer mass is kept. Returns true: it takes no memory. */
bool gravity_create(struct gravity *g, size_t bodies, const double mass[],
                    double k2, double softening);

/* Chooses the kernel tree, which treats a cell as one mass if its width is
   less than theta times its distance; theta is 0 to GRAVITY_WIDEST. Returns
   false, with nothing changed, when there is no memory. */
bool gravity_use_tree(struct gravity *g, double theta);

/* Frees what gravity_create and gravity_use_tree took. */
void gravity_free(struct gravity *g);

/* Adds to a[] the accelerations of bodies at x[], both of 3 * bodies
   numbers, axis by axis: (9.2, eq:softened-force). Without softening,
   bodies in one place make NaN. The bits do not depend on the number of
   threads. */
void gravity_add(const struct gravity *g, const double x[], double a[]);

/* Returns these accelerations as forces for stepping_begin; g must outlive
   them. */
struct stepping_forces gravity_forces(struct gravity *g);

/* Returns the potential energy, in units of mass 1 times velocity squared:
   (9.1, eq:softened-potential). */
double gravity_potential(const struct gravity *g, const double x[]);

/* Returns whether this build on this machine has a kernel of its own, not
   on a device; and the fastest of those that it has, which may round
   otherwise than GRAVITY_AUTO. */
bool gravity_can(enum gravity_kernel kernel);
enum gravity_kernel gravity_fastest(void);

/* Returns how the sum is made: "pairs", "sources", or the name of the
   kernel. */
const char *gravity_summed_by(const struct gravity *g);

#endif
