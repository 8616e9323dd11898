/* From chapters/09-gravity.nw: edit there, then run make tangle. */
/* checksum 4262262193 of the lines below */
/* Sums pulls pair by pair, in blocks of bodies, by AVX-512, by a tree. */
#include "forces/gravity.h"

#include "toolbox/vector.h"

#include <math.h>
#include <stdlib.h>
#ifdef VECTOR_AVX512
#include <immintrin.h>
#endif

const char *const gravity_kernels[] = {
    "auto", "portable", "avx512", "tree", "opencl", "opencl-float", NULL};

static void add_pairs(const struct gravity *g, const double x[], double a[])
{
    const size_t n = g->bodies;
    const double *y = x + n, *z = y + n, *m = g->mass;
    double *b = a + n, *c = b + n;
    const double least = g->softening * g->softening;
    for (size_t i = 0; i < n; ++i)
        for (size_t j = i + 1; j < n; ++j) {
            const double dx = x[j] - x[i], dy = y[j] - y[i];
            const double dz = z[j] - z[i];
            const double s = dx * dx + dy * dy + dz * dz + least;
            const double w = g->k2 / (s * sqrt(s));
            const double to_i = w * m[j], to_j = w * m[i];
            a[i] += to_i * dx;
            b[i] += to_i * dy;
            c[i] += to_i * dz;
            a[j] -= to_j * dx;
            b[j] -= to_j * dy;
            c[j] -= to_j * dz;
        }
}

enum { BLOCK = 16 }; /* two registers or more of whatever there is */

/* Bodies that are pulled, and what they have got so far. */
struct block {
    double x[BLOCK], y[BLOCK], z[BLOCK];
    double a[BLOCK], b[BLOCK], c[BLOCK];
};

/* Adds what a mass at a place pulls at all of a block, least being the
   square of the softening; body `self` of the block, if it has one, is the
   mass itself. */
static inline void pull_by(double m, double x, double y, double z,
                           double least, size_t self, struct block *o)
{
    for (size_t k = 0; k < BLOCK; ++k) {
        const double dx = x - o->x[k], dy = y - o->y[k], dz = z - o->z[k];
        const double s =
            dx * dx + dy * dy + dz * dz + (k == self ? 1 : least);
        const double w = m / (s * sqrt(s));
        o->a[k] += w * dx;
        o->b[k] += w * dy;
        o->c[k] += w * dz;
    }
}

/* The same of body j. */
static inline void pull(const struct gravity *g, const double p[], size_t j,
                        double least, size_t self, struct block *o)
{
    const size_t n = g->bodies;
    pull_by(g->mass[j], p[j], p[n + j], p[2 * n + j], least, self, o);
}

/* The block of bodies i to before end. */
static inline struct block block_of(const struct gravity *g,
                                    const double x[], size_t i, size_t end)
{
    struct block o = {{0}, {0}, {0}, {0}, {0}, {0}};
    for (size_t k = 0; k < BLOCK; ++k) {
        const size_t at = i + k < end ? i + k : end - 1;
        o.x[k] = x[at];
        o.y[k] = x[g->bodies + at];
        o.z[k] = x[2 * g->bodies + at];
    }
    return o;
}

VECTOR_LOOP static void add_portable(const struct gravity *g,
                                     const double x[], double a[], size_t i)
{
    const size_t n = g->bodies, end = n - i < BLOCK ? n : i + BLOCK;
    const double least = g->softening * g->softening;
    struct block o = block_of(g, x, i, end);
    for (size_t j = 0; j < i; ++j)
        pull(g, x, j, least, BLOCK, &o);
    for (size_t j = i; j < end; ++j)
        pull(g, x, j, least, j - i, &o);
    for (size_t j = end; j < n; ++j)
        pull(g, x, j, least, BLOCK, &o);
    for (size_t k = 0; k < end - i; ++k) {
        a[i + k] += g->k2 * o.a[k];
        a[n + i + k] += g->k2 * o.b[k];
        a[2 * n + i + k] += g->k2 * o.c[k];
    }
}

/* Adds to bodies first to last - 1 what body j pulls at them. */
static void add_source(const struct gravity *g, const double x[],
                       double a[], size_t j, size_t first, size_t last)
{
    const size_t n = g->bodies;
    const double *y = x + n, *z = y + n;
    const double least = g->softening * g->softening;
    const double pull = g->k2 * g->mass[j];
    double *b = a + n, *c = b + n;
    for (size_t i = first; i < last; ++i) {
        const double dx = x[j] - x[i], dy = y[j] - y[i], dz = z[j] - z[i];
        const double s = dx * dx + dy * dy + dz * dz + least;
        const double w = pull * g->share[i] / (s * sqrt(s));
        a[i] += w * dx;
        b[i] += w * dy;
        c[i] += w * dz;
    }
}

static void add_sources(const struct gravity *g, const double x[],
                        double a[])
{
    for (size_t k = 0; k < g->sources; ++k) {
        const size_t j = g->source[k];
        add_source(g, x, a, j, 0, j);
        add_source(g, x, a, j, j + 1, g->bodies);
    }
}

#ifdef VECTOR_AVX512
/* m / s^(3/2). */
VECTOR_AVX512 static inline __m512d weight8(__m512d s, __m512d m)
{
    const __m512d y = _mm512_rsqrt14_pd(s), y2 = _mm512_mul_pd(y, y);
    const __m512d e = _mm512_fnmadd_pd(s, y2, _mm512_set1_pd(1));
    __m512d p = _mm512_set1_pd(35. / 16);
    p = _mm512_fmadd_pd(p, e, _mm512_set1_pd(15. / 8));
    p = _mm512_fmadd_pd(p, e, _mm512_set1_pd(3. / 2));
    p = _mm512_mul_pd(p, e);
    const __m512d w = _mm512_mul_pd(_mm512_mul_pd(m, y), y2);
    return _mm512_fmadd_pd(w, p, w);
}

/* Eight bodies that are pulled, and what they have got so far. */
struct eight {
    __m512d x, y, z, a, b, c;
};

/* Adds what body j pulls at the eight; s, the squares of the softening. */
VECTOR_AVX512 static inline void pull8(const struct gravity *g,
                                       const double x[], size_t j,
                                       __m512d s, struct eight *f)
{
    const size_t n = g->bodies;
    const __m512d dx = _mm512_sub_pd(_mm512_set1_pd(x[j]), f->x);
    const __m512d dy = _mm512_sub_pd(_mm512_set1_pd(x[n + j]), f->y);
    const __m512d dz = _mm512_sub_pd(_mm512_set1_pd(x[2 * n + j]), f->z);
    s = _mm512_fmadd_pd(dx, dx, s);
    s = _mm512_fmadd_pd(dy, dy, s);
    s = _mm512_fmadd_pd(dz, dz, s);
    const __m512d w = weight8(s, _mm512_set1_pd(g->mass[j]));
    f->a = _mm512_fmadd_pd(w, dx, f->a);
    f->b = _mm512_fmadd_pd(w, dy, f->b);
    f->c = _mm512_fmadd_pd(w, dz, f->c);
}

VECTOR_AVX512 static void add_avx512(const struct gravity *g,
                                     const double x[], double a[], size_t i)
{
    const size_t n = g->bodies, end = n - i < 8 ? n : i + 8;
    const __mmask8 own = (__mmask8)((1u << (end - i)) - 1);
    const __m512d one = _mm512_set1_pd(1);
    const __m512d least = _mm512_set1_pd(g->softening * g->softening);
    struct eight f = {.x = _mm512_maskz_loadu_pd(own, x + i),
                      .y = _mm512_maskz_loadu_pd(own, x + n + i),
                      .z = _mm512_maskz_loadu_pd(own, x + 2 * n + i)};
    f.a = f.b = f.c = _mm512_setzero_pd();
    for (size_t j = 0; j < i; ++j)
        pull8(g, x, j, least, &f);
    for (size_t j = i; j < end; ++j) {
        const __mmask8 self = (__mmask8)(1u << (j - i));
        pull8(g, x, j, _mm512_mask_mov_pd(least, self, one), &f);
    }
    for (size_t j = end; j < n; ++j)
        pull8(g, x, j, least, &f);
    const __m512d k2 = _mm512_set1_pd(g->k2);
    const __m512d sum[] = {f.a, f.b, f.c};
    for (size_t k = 0; k < 3; ++k) {
        double *to = a + k * n + i;
        const __m512d old = _mm512_maskz_loadu_pd(own, to);
        _mm512_mask_storeu_pd(to, own, _mm512_fmadd_pd(k2, sum[k], old));
    }
}
#endif

/* A cube: what its bodies weigh, and where. */
struct cell {
    double mass, x, y, z, side;
    size_t first, end; /* its bodies in the order of the tree */
    size_t next;       /* the cell to go on with if it is not opened */
};

/* What the kernel tree works in; for each of its bodies the number, and
   x, y, z and the mass, axis by axis. */
struct gravity_tree {
    double theta2, least; /* least: of the sides of cells */
    size_t bodies, cells;
    const double *mass; /* of the caller, in the caller's order */
    struct cell *cell;
    uint32_t *body;
    double *place;
};

static void fell(struct gravity_tree *t)
{
    if (!t)
        return;
    free(t->cell);
    free(t->body);
    free(t->place);
    free(t);
}

static struct gravity_tree *make_tree(size_t n, const double mass[],
                                      double theta)
{
    struct gravity_tree *t = malloc(sizeof *t);
    if (!t)
        return NULL;
    *t = (struct gravity_tree){.theta2 = theta * theta,
                               .bodies = n,
                               .mass = mass,
                               .cell = calloc(2 * n, sizeof *t->cell),
                               .body = calloc(n, sizeof *t->body),
                               .place = calloc(4 * n, sizeof *t->place)};
    if (t->cell && t->body && t->place)
        return t;
    fell(t);
    return NULL;
}

/* Swaps those of bodies first to end - 1 that have less than `middle` of a
   coordinate to the front; returns where the others begin. */
static size_t sort(struct gravity_tree *t, const double x[], size_t first,
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

/* A cube of space. */
struct cube {
    double corner[3], side;
};

/* Part q of a cube: bit k of q says which half along axis k. */
static struct cube eighth(struct cube c, int q)
{
    c.side /= 2;
    for (int k = 0; k < 3; ++k)
        c.corner[k] += (q >> k & 1) * c.side;
    return c;
}

/* Sorts the bodies part[0] to part[8] - 1 into eighths of the cube, part q
   from part[q] on; makes the cube smaller as long as one eighth has all.
   Returns false if they cannot be parted. */
static bool divide(struct gravity_tree *t, const double x[], size_t part[9],
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

static void copy_bodies(struct gravity_tree *t, const double x[],
                        size_t first, size_t end)
{
    const size_t n = t->bodies;
    for (size_t j = first; j < end; ++j) {
        const size_t i = t->body[j];
        for (size_t k = 0; k < 3; ++k)
            t->place[k * n + j] = x[k * n + i];
        t->place[3 * n + j] = t->mass[i];
    }
}

/* What bodies first to end - 1 weigh, and where. */
static struct cell weigh(const struct gravity_tree *t, size_t first,
                         size_t end, double side)
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

/* Makes the cell of bodies first to end - 1, and those in it. */
static void grow(struct gravity_tree *t, const double x[], size_t first,
                 size_t end, struct cube c)
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

/* Makes the tree of bodies at x. */
static void plant(struct gravity_tree *t, const double x[])
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

/* The box round the bodies of a block. */
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

/* Does the cell look small from everywhere in the box? */
static inline bool is_small(const struct gravity_tree *t,
                            const struct cell *c, const struct box *b)
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

/* Adds what all bodies pull at those of the block that begins with i. */
static inline void walk(const struct gravity *g, size_t i, struct block *o)
{
    const struct gravity_tree *t = g->tree;
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

VECTOR_LOOP static void add_by_tree(const struct gravity *g,
                                    const double x[], double a[], size_t i)
{
    const size_t n = g->bodies, end = n - i < BLOCK ? n : i + BLOCK;
    const struct gravity_tree *t = g->tree;
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

bool gravity_create(struct gravity *g, size_t bodies, const double mass[],
                    double k2, double softening)
{
    *g = (struct gravity){.bodies = bodies,
                          .mass = mass,
                          .k2 = k2,
                          .softening = softening,
                          .kernel = GRAVITY_AUTO,
                          .threads = 1};
    return true;
}

void gravity_free(struct gravity *g)
{
    fell(g->tree);
    *g = (struct gravity){0};
}

bool gravity_plant(struct gravity *g, double theta)
{
    struct gravity_tree *t = make_tree(g->bodies, g->mass, theta);
    if (!t)
        return false;
    fell(g->tree);
    g->tree = t;
    g->kernel = GRAVITY_TREE;
    return true;
}

bool gravity_can(enum gravity_kernel kernel)
{
#ifdef VECTOR_AVX512
    if (kernel == GRAVITY_AVX512)
        return VECTOR_HAS("avx512f");
#endif
    return kernel != GRAVITY_AVX512 && kernel < GRAVITY_OPENCL;
}

enum gravity_kernel gravity_fastest(void)
{
    return gravity_can(GRAVITY_AVX512) ? GRAVITY_AVX512 : GRAVITY_PORTABLE;
}

/* Who adds what all bodies pull at `width` bodies from number i on. */
struct kernel {
    size_t width;
    void (*add)(const struct gravity *g, const double x[], double a[],
                size_t i);
};

static const struct kernel kernels[GRAVITY_KERNELS] = {
    [GRAVITY_AUTO] = {BLOCK, add_portable},
    [GRAVITY_PORTABLE] = {BLOCK, add_portable},
#ifdef VECTOR_AVX512
    [GRAVITY_AVX512] = {8, add_avx512},
#endif
    [GRAVITY_TREE] = {BLOCK, add_by_tree},
};

const char *gravity_summed_by(const struct gravity *g)
{
    if (g->source)
        return "sources";
    if (g->bodies <= GRAVITY_FEW)
        return "pairs";
    return gravity_kernels[g->kernel == GRAVITY_AUTO ? GRAVITY_PORTABLE
                                                     : g->kernel];
}

void gravity_add(const struct gravity *g, const double x[], double a[])
{
    if (g->source) {
        add_sources(g, x, a);
        return;
    }
    if (g->bodies <= GRAVITY_FEW) {
        add_pairs(g, x, a);
        return;
    }
    if (g->elsewhere) {
        g->elsewhere(g->device, x, a);
        return;
    }
    const struct kernel *k = &kernels[g->kernel];
    const long n = (long)g->bodies, width = (long)k->width;
    if (g->kernel == GRAVITY_TREE)
        plant(g->tree, x);
#ifdef _OPENMP
#pragma omp parallel for num_threads(g->threads) if (g->threads > 1)
#endif
    for (long i = 0; i < n; i += width)
        k->add(g, x, a, (size_t)i);
}

static void accelerate(void *what, const double x[], const double v[],
                       double a[])
{
    const struct gravity *g = what;
    const double zero = 0 * g->k2;
    (void)v;
    for (size_t k = 0; k < 3 * g->bodies; ++k)
        a[k] = zero;
    gravity_add(g, x, a);
}

struct stepping_forces gravity_forces(struct gravity *g)
{
    return (struct stepping_forces){3 * g->bodies, false, accelerate, g};
}

double gravity_potential(const struct gravity *g, const double x[])
{
    const size_t n = g->bodies;
    const double *y = x + n, *z = y + n, *m = g->mass;
    const double least = g->softening * g->softening;
    double sum = 0;
    for (size_t i = 0; i < n; ++i) {
        double row = 0;
        for (size_t j = i + 1; j < n; ++j) {
            const double dx = x[j] - x[i], dy = y[j] - y[i];
            const double dz = z[j] - z[i];
            const double s = dx * dx + dy * dy + dz * dz + least;
            row += m[j] / sqrt(s);
        }
        sum += m[i] * row;
    }
    return -g->k2 * sum;
}
