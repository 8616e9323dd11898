/* Collides spheres that a step has left in each other, and shifts them. */
#ifndef SPHERES_H
#define SPHERES_H

#include "scenes/scene.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What is done about pairs that overlap after a step. */
enum spheres_rule {
    SPHERES_ALL,        /* all are reflected, as in MPPhys */
    SPHERES_APPROACHING /* those that part are only pushed apart */
};

/* How the two are moved so that they overlap no more. */
enum spheres_shift {
    SPHERES_BY_RADIUS, /* apart, in proportion to the radii, as in MPPhys */
    SPHERES_BY_MASS,   /* apart, with the centre of mass at rest */
    SPHERES_BACK       /* back to where they touched, and on from there */
};

/* The order in which pairs that overlap after a step are resolved. */
enum spheres_order {
    SPHERES_ASCENDING,  /* by the smaller number, then by the larger */
    SPHERES_DESCENDING, /* the other way round */
    SPHERES_DEEPEST,    /* by depth; equal ones ascending */
    SPHERES_ORDERS
};

/* How pairs are found; what comes out is the same. */
enum spheres_search {
    SPHERES_AUTO,  /* by the sweep, but for a few */
    SPHERES_PAIRS, /* every pair is looked at */
    SPHERES_SWEEP  /* along one axis */
};

enum {
    SPHERES_AXES = 3,
    SPHERES_PASSED =
        1000 /* pairs that passed unseen, at most, are counted */
};

/* Two bodies that overlap, a < b. */
struct spheres_pair {
    uint32_t a, b;
    double depth; /* m */
};

/* A body in the order along an axis. */
struct spheres_edge {
    double place[SPHERES_AXES], radius; /* m; folded into the box */
    uint32_t body;
};

/* The contacts of a scene. What stands above the first line may be changed
   between steps; the counts are to be read, and may be set to 0. */
struct spheres {
    enum spheres_rule rule;
    enum spheres_shift shift;
    enum spheres_order order;
    enum spheres_search search;
    double dt; /* the scene's step, s; SPHERES_BACK goes back no further */
    double restitution;
    /* ---- counted by spheres_resolve */
    uint64_t collisions, wall_collisions;
    uint64_t receding; /* of the collisions: of pairs that were parting */
    uint64_t tested;   /* pairs looked at for an overlap */
    double impulse[SPHERES_AXES]; /* that walls across an axis took, N s */
    double virial; /* what collisions have added to the sum of m x v, J s */
    double depth;  /* the deepest overlap of a collision, m */
    uint64_t passed;     /* pairs that a step took through each other */
    uint32_t through[2]; /* the first of them */
    /* ---- private */
    const struct scene *scene;
    double *inverse; /* 1/mass along each axis, 1/kg; 0 where fixed */
    double widest;   /* radius, m */
    double margin;   /* pairs nearer than this are listed, too, m */
    double narrow;   /* the least sum of two radii, but for two points, m */
    double furthest; /* that two can come nearer in a step, m */
    double half[SPHERES_AXES]; /* of a periodic box; INFINITY, m */
    size_t axis;               /* of the sweep */
    bool sorted;
    struct spheres_edge *edge;
    struct spheres_pair *pair;
    size_t pairs, capacity;
};

/* Prepares for the bodies of a scene, which has to outlive *p: its masses
   (positive), radii, freedom, walls, restitution and dt. The shift is by
   radius. Returns false, with nothing to free, when there is no memory. */
bool spheres_create(struct spheres *p, const struct scene *s,
                    enum spheres_rule rule);
void spheres_free(struct spheres *p);

/* Does to bodies at x (m) with velocities v (m/s), both axis by axis as in
   a scene, what has to be done after a step: walls, then pairs that
   overlap, in their order. Returns how many collisions of both kinds there
   were. A pair that overlaps only after its turn waits for the next step.
   Sources: (11.1, eq:contact-impulse), (11.2, eq:back-time), (11.3,
   eq:push). */
uint64_t spheres_resolve(struct spheres *p, double x[], double v[]);

/* Reflects two bodies that touch and approach, or turns a body round that
   has come to a wall across axis k: velocities only, and the counts. */
void spheres_reflect(struct spheres *p, size_t a, size_t b,
                     const double x[], double v[]);
void spheres_bounce(struct spheres *p, size_t i, size_t k, double v[]);

/* Finds the pairs that overlap, ascending, each once: p->pair. Returns how
   many. */
size_t spheres_overlaps(struct spheres *p, const double x[]);

/* Returns how deep bodies of a scene with contacts overlap, or reach beyond
   a hard wall that they do not come back from, m; 0: nowhere, or there are
   no contacts. INFINITY if memory runs out. Where and when such bodies
   touched cannot be known, and what becomes of them depends on the step:
   programs refuse them, or say so. */
double spheres_depth(const struct scene *s);

/* Counts in p->passed pairs that the last step, p->dt long, took through
   each other. spheres_resolve does that by itself. */
void spheres_watch(struct spheres *p, const double x[], const double v[]);

/* Returns the way from body a to body b along axis k, to its nearest image,
   m. */
double spheres_way(const struct scene *s, const double x[], size_t a,
                   size_t b, size_t k);
#endif
