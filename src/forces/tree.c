/* From chapters/09-gravity.nw: edit there, then run make tangle. */
/* checksum 3955932742 of the lines below */
/* Sums gravity by a tree: a distant cell of bodies acts as one mass. */
#include "forces/tree.h"

#include "forces/pull.h"
#include "toolbox/vector.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

/* A cubic cell: mass and centre of mass of its bodies, and its side. */
struct cell {
    double mass, x, y, z, side;
    size_t first, end; /* its bodies: `first` to end - 1 */
    size_t next;       /* cell to visit next if this cell is not opened */
};

/* A tree. Its bodies are sorted by cells. body[] has the caller's numbers;
   place[] has all values of x, then of y, z and the mass. */
struct tree {
    double theta2, least; /* theta squared; smallest side of a cell */
    size_t bodies, cells;
    const double *mass; /* in the caller's order */
    struct cell *cell;
    uint32_t *body;
    double *place;
};

/* Moves the bodies from `first` to end - 1 with x below `middle` to the
   front. Returns the position of the first of the others. */
static size_t sort(struct tree *t, const double x[], size_t first,
                   size_t end, double middle)
{
    for (size_t n = first; n < end; ++n) {
        const uint32_t i = t->body[n];
        if (x[i] < middle) {
            t->body[n] = t->body[first];
            t->body[first++] = i;
        }
    }
    return first;
}

struct cube {
    double corner[3], side;
};

/* Returns part q of a cube. Bit k of q selects the half along axis k. */
static struct cube eighth(struct cube c, int q)
{
    c.side /= 2;
    for (int k = 0; k < 3; ++k)
        c.corner[k] += (q >> k & 1) * c.side;
    return c;
}

/* Sorts the bodies part[0] to part[8] - 1 into eighths of the cube: those
   of eighth q begin at part[q]. If one eighth contains all bodies, divides
   that instead. Returns false if the bodies cannot be separated. */
static bool divide(struct tree *t, const double x[], size_t part[9],
                   struct cube *c)
{
    while (c->side > t->least) {
        for (int k = 2, wide = 8; k >= 0; --k, wide /= 2)
            for (int q = 0; q < 8; q += wide)
                part[q + wide / 2] =
                    sort(t, x + (size_t)k * t->bodies, part[q],
                         part[q + wide], c->corner[k] + c->side / 2);
        int q = 0;
        while (part[q + 1] == part[0])
            ++q;
        if (part[q + 1] < part[8])
            return true;
        *c = eighth(*c, q);
    }
    return false;
}

static void copy_bodies(struct tree *t, const double x[], size_t first,
                        size_t end)
{
    const size_t n = t->bodies;
    for (size_t j = first; j < end; ++j) {
        const size_t i = t->body[j];
        for (size_t k = 0; k < 3; ++k)
            t->place[k * n + j] = x[k * n + i];
        t->place[3 * n + j] = t->mass[i];
    }
}

/* Returns the cell of bodies `first` to end - 1, with their mass and their
   centre of mass. */
static struct cell weigh(const struct tree *t, size_t first, size_t end,
                         double side)
{
    const size_t n = t->bodies;
    const double *x = t->place, *y = x + n, *z = y + n, *m = z + n;
    struct cell c = {.side = side, .first = first, .end = end};
    for (size_t j = first; j < end; ++j) {
        c.mass += m[j];
        c.x += m[j] * x[j];
        c.y += m[j] * y[j];
        c.z += m[j] * z[j];
    }
    const bool heavy = c.mass > 0;
    c.x = heavy ? c.x / c.mass : x[first];
    c.y = heavy ? c.y / c.mass : y[first];
    c.z = heavy ? c.z / c.mass : z[first];
    return c;
}

/* Creates the cell of bodies `first` to end - 1 and the cells in it. */
static void grow(struct tree *t, const double x[], size_t first, size_t end,
                 struct cube c)
{
    const size_t number = t->cells++;
    size_t part[9] = {first, 0, 0, 0, 0, 0, 0, 0, end};
    const bool parts = end - first > BLOCK && divide(t, x, part, &c);
    for (int q = 0; parts && q < 8; ++q)
        if (part[q] < part[q + 1])
            grow(t, x, part[q], part[q + 1], eighth(c, q));
    if (!parts)
        copy_bodies(t, x, first, end);
    t->cell[number] = weigh(t, first, end, c.side);
    t->cell[number].next = t->cells;
}

void tree_build(struct tree *t, const double x[])
{
    struct cube c = {{0}, 0};
    t->cells = 0;
    t->least = 0;
    for (size_t k = 0; k < 3; ++k) {
        const double *at = x + k * t->bodies;
        double most = c.corner[k] = at[0];
        for (size_t i = 0; i < t->bodies; ++i) {
            c.corner[k] = fmin(c.corner[k], at[i]);
            most = fmax(most, at[i]);
        }
        c.side = fmax(c.side, most - c.corner[k]);
        t->least = fmax(t->least, fmax(most, -c.corner[k]) / (1 << 30));
    }
    for (size_t i = 0; i < t->bodies; ++i)
        t->body[i] = (uint32_t)i;
    grow(t, x, 0, t->bodies, c);
}

/* The box around the bodies of a block. */
struct box {
    double least[3], most[3];
};

static inline struct box box_of(const struct block *o)
{
    struct box b = {{o->x[0], o->y[0], o->z[0]},
                    {o->x[0], o->y[0], o->z[0]}};
    for (size_t i = 1; i < BLOCK; ++i) {
        const double at[] = {o->x[i], o->y[i], o->z[i]};
        for (int k = 0; k < 3; ++k) {
            b.least[k] = at[k] < b.least[k] ? at[k] : b.least[k];
            b.most[k] = at[k] > b.most[k] ? at[k] : b.most[k];
        }
    }
    return b;
}

/* Returns whether the cell may act as one mass on all bodies in the box. */
static inline bool is_small(const struct tree *t, const struct cell *c,
                            const struct box *b)
{
    const double at[] = {c->x, c->y, c->z};
    double d2 = 0;
    for (int k = 0; k < 3; ++k) {
        const double below = b->least[k] - at[k];
        const double above = at[k] - b->most[k];
        const double d = below > 0 ? below : above > 0 ? above : 0;
        d2 += d * d;
    }
    return c->side * c->side < t->theta2 * d2;
}

/* Adds the accelerations due to all bodies to the block *o, which begins
   with body i. */
static inline void walk(const struct gravity *g, size_t i, struct block *o)
{
    const struct tree *t = g->tree;
    const double *x = t->place, *y = x + t->bodies, *z = y + t->bodies;
    const double *m = z + t->bodies, least = g->softening * g->softening;
    const struct box box = box_of(o);
    for (size_t n = 0; n < t->cells;) {
        const struct cell *c = &t->cell[n];
        const bool far = is_small(t, c, &box), leaf = c->next == n + 1;
        if (far)
            pull_by(c->mass, c->x, c->y, c->z, least, BLOCK, o);
        for (size_t j = c->first; !far && leaf && j < c->end; ++j)
            pull_by(m[j], x[j], y[j], z[j], least, j - i, o);
        n = far ? c->next : n + 1;
    }
}

VECTOR_LOOP void tree_add(const struct gravity *g, const double x[],
                          double a[], size_t i)
{
    const size_t n = g->bodies, end = n - i < BLOCK ? n : i + BLOCK;
    const struct tree *t = g->tree;
    struct block o = block_of(g, t->place, i, end);
    (void)x;
    walk(g, i, &o);
    for (size_t k = 0; k < end - i; ++k) {
        const size_t j = t->body[i + k];
        a[j] += g->k2 * o.a[k];
        a[n + j] += g->k2 * o.b[k];
        a[2 * n + j] += g->k2 * o.c[k];
    }
}

struct tree *tree_create(size_t n, const double mass[], double theta)
{
    struct tree *t = malloc(sizeof *t);
    if (!t)
        return NULL;
    *t = (struct tree){.theta2 = theta * theta,
                       .bodies = n,
                       .mass = mass,
                       .cell = calloc(2 * n, sizeof *t->cell),
                       .body = calloc(n, sizeof *t->body),
                       .place = calloc(4 * n, sizeof *t->place)};
    if (t->cell && t->body && t->place)
        return t;
    tree_free(t);
    return NULL;
}

void tree_free(struct tree *t)
{
    if (!t)
        return;
    free(t->cell);
    free(t->body);
    free(t->place);
    free(t);
}
