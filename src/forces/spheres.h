/* Resolves collisions of spheres that overlap after a step. */
#ifndef SPHERES_H
#define SPHERES_H

#include "scenes/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Which pairs that overlap after a step are reflected. */
enum spheres_rule {
    SPHERES_ALL,        /* all of them, as in MPPhys */
    SPHERES_APPROACHING /* only approaching pairs; others are moved apart */
};

/* How an overlapping pair is moved apart. */
enum spheres_shift {
    SPHERES_BY_RADIUS, /* in proportion to the radii, as in MPPhys */
    SPHERES_BY_MASS,   /* without moving the centre of mass */
    SPHERES_BACK       /* back to the contact, then on with the new
                          velocities */
};

/* The order in which pairs that overlap after a step are resolved. */
enum spheres_order {
    SPHERES_ASCENDING,  /* by the smaller body number, then the larger */
    SPHERES_DESCENDING, /* the reverse order */
    SPHERES_DEEPEST,    /* by depth, the deepest first */
    SPHERES_ORDERS
};

/* How pairs are found. This does not affect the results. */
enum spheres_search {
    SPHERES_AUTO,  /* PAIRS for a few bodies, otherwise SWEEP */
    SPHERES_PAIRS, /* every pair is tested */
    SPHERES_SWEEP  /* only neighbours along one axis are tested */
};

enum {
    SPHERES_AXES = 3,
    SPHERES_PASSED = 1000 /* counting of missed collisions stops here */
};

/* Two bodies that overlap, a < b. */
struct spheres_pair {
    uint32_t a, b;
    double depth; /* m */
};

/* A body in the list sorted along an axis. */
struct spheres_edge {
    double place[SPHERES_AXES], radius; /* m; position folded into the
                                           box */
    uint32_t body;
};

/* The contacts of a scene. Members above the first dashed line may be set
   between steps. Members above the second dashed line may be read, and set
   to 0. */
struct spheres {
    enum spheres_rule rule;
    enum spheres_shift shift;
    enum spheres_order order;
    enum spheres_search search;
    double dt; /* the step, s; the longest time that SPHERES_BACK goes
                  back */
    double restitution;
    /* ---- counted by spheres_resolve */
    uint64_t collisions, wall_collisions;
    uint64_t receding; /* collisions of pairs that were separating */
    uint64_t tested;   /* pairs tested for an overlap */
    double impulse[SPHERES_AXES]; /* on walls normal to each axis, N s */
    double virial;       /* change of the sum of m x v by collisions, J s */
    double depth;        /* deepest overlap in a collision, m */
    uint64_t passed;     /* pairs that moved through each other in a step */
    uint32_t through[2]; /* the first such pair */
    /* ---- private */
    const struct scene *scene;
    double *inverse; /* [3 * bodies] inverse mass, 1/kg; 0 if fixed */
    double widest;   /* largest radius, m */
    double margin;   /* pairs nearer than this are listed, m */
    double narrow;   /* smallest sum of two radii that is not 0, m */
    double furthest; /* two bodies approach by at most this in a step, m */
    double half[SPHERES_AXES]; /* half the side of a periodic box, or
                                  INFINITY, m */
    size_t axis;               /* axis of the sweep */
    bool sorted;
    struct spheres_edge *edge;
    struct spheres_pair *pair;
    size_t pairs, capacity;
};

/* Prepares *p for the bodies of a scene, which must outlive *p. Uses the
   scene's masses (positive), radii, freedom, walls, restitution and dt. The
   shift is SPHERES_BY_RADIUS. Returns false, with nothing to free, if
   memory runs out. */
bool spheres_create(struct spheres *p, const struct scene *s,
                    enum spheres_rule rule);
void spheres_free(struct spheres *p);

/* Resolves the collisions after a step, first with walls, then of
   overlapping pairs in p->order. Changes x (in m) and v (in m/s), arranged
   as in a scene. Returns the number of all collisions. If a pair begins to
   overlap after its turn, it is left to the next step. Sources: (11.1,
   eq:contact-impulse), (11.2, eq:back-time), (11.3, eq:push). */
uint64_t spheres_resolve(struct spheres *p, double x[], double v[]);

/* Reflect two bodies that touch and approach each other, or one body at a
   wall normal to axis k. Only velocities and counts change. */
void spheres_reflect(struct spheres *p, size_t a, size_t b,
                     const double x[], double v[]);
void spheres_bounce(struct spheres *p, size_t i, size_t k, double v[]);

/* Lists the overlapping pairs in p->pair, ascending, each once. Returns
   their number. */
size_t spheres_overlaps(struct spheres *p, const double x[]);

/* Returns the largest depth (in m) to which two bodies overlap, or to
   which a body extends beyond a hard wall unless it is moving back.
   Returns 0 if no body does, or if the scene has no contacts, and INFINITY
   if memory runs out. Programs refuse scenes with such bodies, or warn: it
   is unknown where and when the bodies touched, so their motion would
   depend on the step. */
double spheres_depth(const struct scene *s);

/* Counts in p->passed the pairs that moved through each other in the last
   step, of length p->dt. spheres_resolve also does this. */
void spheres_watch(struct spheres *p, const double x[], const double v[]);

/* Returns the coordinate difference along axis k (in m) from body a to the
   nearest image of body b. */
double spheres_way(const struct scene *s, const double x[], size_t a,
                   size_t b, size_t k);
#endif
