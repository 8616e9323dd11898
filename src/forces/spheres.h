/* Collides spheres that overlap after a step, and moves them apart. */
#ifndef SPHERES_H
#define SPHERES_H

#include "scenes/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Which pairs that overlap after a step are reflected. */
enum spheres_rule {
    SPHERES_ALL,        /* all of them, as in MPPhys */
    SPHERES_APPROACHING /* those that approach; others are moved apart */
};

/* How an overlapping pair is moved apart. */
enum spheres_shift {
    SPHERES_BY_RADIUS, /* in proportion to the radii, as in MPPhys */
    SPHERES_BY_MASS,   /* with the centre of mass at rest */
    SPHERES_BACK       /* back to the contact, and on with new velocities */
};

/* The order in which pairs that overlap after a step are resolved. */
enum spheres_order {
    SPHERES_ASCENDING,  /* by the smaller number, then by the larger */
    SPHERES_DESCENDING, /* the reverse order */
    SPHERES_DEEPEST,    /* by depth, the deepest first */
    SPHERES_ORDERS
};

/* How pairs are found; the results are equal. */
enum spheres_search {
    SPHERES_AUTO,  /* PAIRS for a few bodies, otherwise SWEEP */
    SPHERES_PAIRS, /* every pair is tested */
    SPHERES_SWEEP  /* neighbours along one axis */
};

enum {
    SPHERES_AXES = 3,
    SPHERES_PASSED = 1000 /* most missed collisions that are counted */
};

/* Two bodies that overlap, a < b. */
struct spheres_pair {
    uint32_t a, b;
    double depth; /* m */
};

/* A body in the list sorted along an axis. */
struct spheres_edge {
    double place[SPHERES_AXES], radius; /* m; folded into the box */
    uint32_t body;
};

/* The contacts of a scene. The members above the first line may be changed
   between steps; the counts may be read, and set to 0. */
struct spheres {
    enum spheres_rule rule;
    enum spheres_shift shift;
    enum spheres_order order;
    enum spheres_search search;
    double dt; /* the scene's step, s; SPHERES_BACK goes back less */
    double restitution;
    /* ---- counted by spheres_resolve */
    uint64_t collisions, wall_collisions;
    uint64_t receding; /* collisions of pairs that were separating */
    uint64_t tested;   /* pairs tested for an overlap */
    double impulse[SPHERES_AXES]; /* given to walls across an axis, N s */
    double virial;       /* change of the sum of m x v by collisions, J s */
    double depth;        /* deepest overlap in a collision, m */
    uint64_t passed;     /* pairs that a step moved through each other */
    uint32_t through[2]; /* the first such pair */
    /* ---- private */
    const struct scene *scene;
    double *inverse; /* 1/mass along each axis, 1/kg; 0 if fixed */
    double widest;   /* largest radius, m */
    double margin;   /* pairs nearer than this are listed, m */
    double narrow;   /* least sum of two radii that is not 0, m */
    double furthest; /* most by which two can approach in a step, m */
    double half[SPHERES_AXES]; /* half a periodic side, or INFINITY, m */
    size_t axis;               /* axis of the sweep */
    bool sorted;
    struct spheres_edge *edge;
    struct spheres_pair *pair;
    size_t pairs, capacity;
};

/* Prepares for the bodies of a scene, which must outlive *p: its masses
   (positive), radii, freedom, walls, restitution and dt. The shift is by
   radius. Returns false, with nothing to free, if memory runs out. */
bool spheres_create(struct spheres *p, const struct scene *s,
                    enum spheres_rule rule);
void spheres_free(struct spheres *p);

/* Resolves the collisions after a step, at walls, then of overlapping pairs
   in p->order: changes x (m) and v (m/s), both axis by axis as in a scene.
   Returns the number of collisions of both kinds. A pair that overlaps only
   after its turn waits for the next step. Sources: (11.1,
   eq:contact-impulse), (11.2, eq:back-time), (11.3, eq:push). */
uint64_t spheres_resolve(struct spheres *p, double x[], double v[]);

/* Reflect two bodies that touch and approach, and reverse a body at a wall
   across axis k. Only velocities and counts change. */
void spheres_reflect(struct spheres *p, size_t a, size_t b,
                     const double x[], double v[]);
void spheres_bounce(struct spheres *p, size_t i, size_t k, double v[]);

/* Finds the overlapping pairs, ascending, each once, in p->pair. Returns
   their number. */
size_t spheres_overlaps(struct spheres *p, const double x[]);

/* Returns how deep bodies of a scene with contacts overlap, or extend
   beyond a hard wall without moving back, m; 0 if nowhere, or without
   contacts; INFINITY if memory runs out. Since the place and time at which
   such bodies touched are unknown, their motion would depend on the step:
   programs refuse them, or warn. */
double spheres_depth(const struct scene *s);

/* Counts in p->passed pairs that the last step, of length p->dt, moved
   through each other. spheres_resolve includes this. */
void spheres_watch(struct spheres *p, const double x[], const double v[]);

/* Returns the coordinate difference from body a to the nearest image of
   body b along axis k, m. */
double spheres_way(const struct scene *s, const double x[], size_t a,
                   size_t b, size_t k);
#endif
