/* Sums gravity over all bodies, by a kernel or over pairs. */
#include "forces/gravity.h"

#include "forces/pull.h"
#include "forces/tree.h"
#include "toolbox/vector.h"

#include <math.h>
#include <stdlib.h>
#ifdef VECTOR_AVX512
#include <immintrin.h>
#endif

const char *const gravity_kernels[] = {
    "auto", "portable", "avx512", "tree", "opencl", "opencl-float", NULL};

/* Adds to *o the accelerations of a block of bodies due to body j. */
static inline void pull(const struct gravity *g, const double p[], size_t j,
                        double least, size_t self, struct block *o)
{
    const size_t n = g->bodies;
    pull_by(g->mass[j], p[j], p[n + j], p[2 * n + j], least, self, o);
}

/* Adds the accelerations of the block that begins with body i due to all
   bodies. The terms of each sum are added in the order of the bodies,
   whatever the vector width of the processor: (sec:gravity-blocks). */
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

/* Adds the accelerations of bodies `first` to last - 1 due to body j. They
   exclude body j, so the loop has no branch and can be vectorised. */
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
        const double w = pull * g->factor[i] / (s * sqrt(s));
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
/* Returns m / s^(3/2) for eight pairs of m and s. An estimate of 1/sqrt(s)
   with a relative error of 2^-14 is corrected by three terms of a power
   series in e, a measure of this error: (9.14, eq:cube). */
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

/* The positions of eight bodies, and their accelerations so far. */
struct eight {
    __m512d x, y, z, a, b, c;
};

/* Adds the accelerations of eight bodies due to body j; s contains the
   squared softening, m^2, in each lane. */
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

/* Adds the accelerations of eight bodies from body i on. Each has its own
   lane, so the order of its sum is unchanged. Lanes beyond the last body
   are masked. For the pull of a body on itself, 1 replaces the squared
   softening, which may be 0: the result is then 0 instead of 0/0. */
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
    tree_free(g->tree);
    *g = (struct gravity){0};
}

bool gravity_use_tree(struct gravity *g, double theta)
{
    struct tree *t = tree_create(g->bodies, g->mass, theta);
    if (!t)
        return false;
    tree_free(g->tree);
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

/* A function that adds the accelerations, due to all bodies, of `width`
   bodies beginning with body i. */
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
    [GRAVITY_TREE] = {BLOCK, tree_add}};

const char *gravity_summed_by(const struct gravity *g)
{
    if (g->source)
        return "sources";
    if (g->bodies <= GRAVITY_FEW)
        return "pairs";
    return gravity_kernels[g->kernel == GRAVITY_AUTO ? GRAVITY_PORTABLE
                                                     : g->kernel];
}

/* The number of threads must not affect the choice of a kernel, since the
   result depends on the kernel. Each thread computes the whole sums of some
   bodies, so no two threads write the same sum. */
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
        tree_build(g->tree, x);
#ifdef _OPENMP
#pragma omp parallel for num_threads(g->threads) if (g->threads > 1)
#endif
    for (long i = 0; i < n; i += width)
        k->add(g, x, a, (size_t)i);
}

/* Sets the accelerations to zero, then adds gravity. The zero is computed
   so that the compiler does not replace the loop by memset. memset stores
   several numbers at once, whereas the sums for two bodies load them one by
   one and would have to wait for its stores. */
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

/* Sums over all pairs, even if the kernel is the tree, as an independent
   check of the tree. For the ring of chapter 9 with theta 0.5, the forces
   of the tree conserve the energy to 1e-8. An energy computed by the tree
   itself had an error of 2e-4, different in each row of the table. */
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
