/* From chapters/09-gravity.nw: edit there, then run make tangle. */
/* checksum 1156794788 of the lines below */
/* Sums pulls pair by pair, body by body, and by vector instructions. */
#include "forces/gravity.h"

#include <math.h>
#if defined(__x86_64__) && defined(__GNUC__)
#define VECTORS
#include <immintrin.h>
#define AVX2 __attribute__((target("avx2,fma")))
#define AVX512 __attribute__((target("avx512f")))
#endif

const char *const gravity_kernels[] = {"portable", "avx2", "avx512", NULL};

bool gravity_create(struct gravity *g, size_t bodies, const double mass[],
                    double k2, double softening)
{
    *g = (struct gravity){.bodies = bodies,
                          .mass = mass,
                          .k2 = k2,
                          .softening = softening,
                          .kernel = GRAVITY_PORTABLE,
                          .threads = 1};
    return true;
}

void gravity_free(struct gravity *g)
{
    *g = (struct gravity){0};
}

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

/* Adds to sum[] what bodies first to last - 1 pull at body i. */
static void pull(const struct gravity *g, const double x[], size_t i,
                 size_t first, size_t last, double sum[3])
{
    const size_t n = g->bodies;
    const double *y = x + n, *z = y + n;
    const double least = g->softening * g->softening;
    double a = sum[0], b = sum[1], c = sum[2];
    for (size_t j = first; j < last; ++j) {
        const double dx = x[j] - x[i], dy = y[j] - y[i], dz = z[j] - z[i];
        const double s = dx * dx + dy * dy + dz * dz + least;
        const double w = g->mass[j] / (s * sqrt(s));
        a += w * dx;
        b += w * dy;
        c += w * dz;
    }
    sum[0] = a;
    sum[1] = b;
    sum[2] = c;
}

static void add_portable(const struct gravity *g, const double x[],
                         double a[], size_t i)
{
    double sum[3] = {0, 0, 0};
    pull(g, x, i, 0, i, sum);
    pull(g, x, i, i + 1, g->bodies, sum);
    for (size_t k = 0; k < 3; ++k)
        a[k * g->bodies + i] += g->k2 * sum[k];
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

#ifdef VECTORS
/* 1 / sqrt(s) to 3.5 per cent, from the bits of s. */
AVX2 static inline __m256d guess(__m256d s)
{
    const __m256i magic = _mm256_set1_epi64x(0x5fe6eb50c7b537a9);
    const __m256i half = _mm256_srli_epi64(_mm256_castpd_si256(s), 1);
    return _mm256_castsi256_pd(_mm256_sub_epi64(magic, half));
}

/* 1 - s y^2: how far y is from 1 / sqrt(s). */
AVX2 static inline __m256d defect4(__m256d s, __m256d y)
{
    return _mm256_fnmadd_pd(s, _mm256_mul_pd(y, y), _mm256_set1_pd(1));
}

/* m / s^(3/2). */
AVX2 static inline __m256d weight4(__m256d s, __m256d m)
{
    __m256d y = guess(s), e = defect4(s, y), p;
    p = _mm256_fmadd_pd(e, _mm256_set1_pd(5. / 16), _mm256_set1_pd(3. / 8));
    p = _mm256_fmadd_pd(p, e, _mm256_set1_pd(1. / 2));
    y = _mm256_fmadd_pd(_mm256_mul_pd(p, e), y, y);
    e = defect4(s, y);
    p = _mm256_fmadd_pd(e, _mm256_set1_pd(15. / 8), _mm256_set1_pd(3. / 2));
    p = _mm256_mul_pd(p, e);
    const __m256d w =
        _mm256_mul_pd(_mm256_mul_pd(m, y), _mm256_mul_pd(y, y));
    return _mm256_fmadd_pd(w, p, w);
}

/* Four bodies that are pulled, and what they have got so far. */
struct four {
    __m256d x, y, z, a, b, c;
};

/* Adds what body j pulls at the four; s, the squares of the softening. */
AVX2 static inline void pull4(const struct gravity *g, const double x[],
                              size_t j, __m256d s, struct four *f)
{
    const size_t n = g->bodies;
    const __m256d dx = _mm256_sub_pd(_mm256_set1_pd(x[j]), f->x);
    const __m256d dy = _mm256_sub_pd(_mm256_set1_pd(x[n + j]), f->y);
    const __m256d dz = _mm256_sub_pd(_mm256_set1_pd(x[2 * n + j]), f->z);
    s = _mm256_fmadd_pd(dx, dx, s);
    s = _mm256_fmadd_pd(dy, dy, s);
    s = _mm256_fmadd_pd(dz, dz, s);
    const __m256d w = weight4(s, _mm256_set1_pd(g->mass[j]));
    f->a = _mm256_fmadd_pd(w, dx, f->a);
    f->b = _mm256_fmadd_pd(w, dy, f->b);
    f->c = _mm256_fmadd_pd(w, dz, f->c);
}

/* All bits of the lanes from low to high - 1. */
AVX2 static inline __m256i lanes(size_t low, size_t high)
{
    const __m256i lane = _mm256_set_epi64x(3, 2, 1, 0);
    const __m256i from = _mm256_set1_epi64x((long long)low - 1);
    const __m256i to = _mm256_set1_epi64x((long long)high);
    return _mm256_and_si256(_mm256_cmpgt_epi64(lane, from),
                            _mm256_cmpgt_epi64(to, lane));
}

AVX2 static void add_avx2(const struct gravity *g, const double x[],
                          double a[], size_t i)
{
    const size_t n = g->bodies, end = n - i < 4 ? n : i + 4;
    const __m256i own = lanes(0, end - i);
    const __m256d one = _mm256_set1_pd(1);
    const __m256d least = _mm256_set1_pd(g->softening * g->softening);
    struct four f = {.x = _mm256_maskload_pd(x + i, own),
                     .y = _mm256_maskload_pd(x + n + i, own),
                     .z = _mm256_maskload_pd(x + 2 * n + i, own)};
    f.a = f.b = f.c = _mm256_setzero_pd();
    for (size_t j = 0; j < i; ++j)
        pull4(g, x, j, least, &f);
    for (size_t j = i; j < end; ++j) {
        const __m256d self = _mm256_castsi256_pd(lanes(j - i, j - i + 1));
        pull4(g, x, j, _mm256_blendv_pd(least, one, self), &f);
    }
    for (size_t j = end; j < n; ++j)
        pull4(g, x, j, least, &f);
    const __m256d k2 = _mm256_set1_pd(g->k2);
    const __m256d sum[] = {f.a, f.b, f.c};
    for (size_t k = 0; k < 3; ++k) {
        double *to = a + k * n + i;
        const __m256d old = _mm256_maskload_pd(to, own);
        _mm256_maskstore_pd(to, own, _mm256_fmadd_pd(k2, sum[k], old));
    }
}
#endif

#ifdef VECTORS
/* m / s^(3/2). */
AVX512 static inline __m512d weight8(__m512d s, __m512d m)
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

struct eight {
    __m512d x, y, z, a, b, c;
};

/* As pull4. */
AVX512 static inline void pull8(const struct gravity *g, const double x[],
                                size_t j, __m512d s, struct eight *f)
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

AVX512 static void add_avx512(const struct gravity *g, const double x[],
                              double a[], size_t i)
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

bool gravity_can(enum gravity_kernel kernel)
{
#ifdef VECTORS
    if (kernel == GRAVITY_AVX2)
        return __builtin_cpu_supports("avx2") &&
               __builtin_cpu_supports("fma");
    if (kernel == GRAVITY_AVX512)
        return __builtin_cpu_supports("avx512f");
#endif
    return kernel == GRAVITY_PORTABLE;
}

enum gravity_kernel gravity_fastest(void)
{
    enum gravity_kernel kernel = GRAVITY_AVX512;
    while (!gravity_can(kernel))
        --kernel;
    return kernel;
}

/* Who adds what all bodies pull at `width` bodies from number i on. */
struct kernel {
    size_t width;
    void (*add)(const struct gravity *g, const double x[], double a[],
                size_t i);
};

static const struct kernel kernels[] = {
    {1, add_portable},
#ifdef VECTORS
    {4, add_avx2},
    {8, add_avx512},
#endif
};

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
    const struct kernel *k = &kernels[g->kernel];
    const long n = (long)g->bodies, width = (long)k->width;
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
