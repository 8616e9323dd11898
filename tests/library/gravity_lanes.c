/* The kernel for AVX-512 where there is none: its source, with functions
   of eight lanes in plain C, whose guess of an inverse root is as far off
   as the processor's may be, 2^-14. */
#include "unit.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(VECTOR_PLAIN)
#include <immintrin.h>

struct lanes {
    double lane[8];
};

#define EACH(expression)                                                   \
    struct lanes r;                                                        \
    for (int k = 0; k < 8; ++k)                                            \
        r.lane[k] = (expression);                                          \
    return r

static struct lanes set1(double a)
{
    EACH(a);
}
static struct lanes sub(struct lanes a, struct lanes b)
{
    EACH(a.lane[k] - b.lane[k]);
}
static struct lanes mul(struct lanes a, struct lanes b)
{
    EACH(a.lane[k] * b.lane[k]);
}
static struct lanes fmadd(struct lanes a, struct lanes b, struct lanes c)
{
    EACH(fma(a.lane[k], b.lane[k], c.lane[k]));
}
static struct lanes fnmadd(struct lanes a, struct lanes b, struct lanes c)
{
    EACH(fma(-a.lane[k], b.lane[k], c.lane[k]));
}
static struct lanes rsqrt14(struct lanes a)
{
    static const double off[8] = {1, -1, .5, -.3, 0, 1, -1, .9};
    EACH(1 / sqrt(a.lane[k]) * (1 + off[k] * 0x1p-14));
}
static struct lanes loadz(unsigned mask, const double *p)
{
    EACH(mask >> k & 1 ? p[k] : 0);
}
static struct lanes move(struct lanes a, unsigned mask, struct lanes b)
{
    EACH(mask >> k & 1 ? b.lane[k] : a.lane[k]);
}
static void store(double *p, unsigned mask, struct lanes a)
{
    for (int k = 0; k < 8; ++k)
        if (mask >> k & 1)
            p[k] = a.lane[k];
}

#define __m512d struct lanes
#define _mm512_set1_pd set1
#define _mm512_setzero_pd() set1(0)
#define _mm512_sub_pd sub
#define _mm512_mul_pd mul
#define _mm512_fmadd_pd fmadd
#define _mm512_fnmadd_pd fnmadd
#define _mm512_rsqrt14_pd rsqrt14
#define _mm512_maskz_loadu_pd loadz
#define _mm512_mask_mov_pd move
#define _mm512_mask_storeu_pd store
/* and no instruction that the test would need a better machine for */
#define target(set) target("avx2,fma")
/* other names than those of the library, which is linked as well */
#define gravity_kernels lanes_kernels
#define gravity_create lanes_create
#define gravity_free lanes_free
#define gravity_use_tree lanes_use_tree
#define gravity_add lanes_add
#define gravity_forces lanes_forces
#define gravity_potential lanes_potential
#define gravity_can lanes_can
#define gravity_fastest lanes_fastest
#define gravity_summed_by lanes_summed_by
#include <forces/gravity.c> /* of src, not of this folder */

static bool can_run(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

TEST(test_lanes, "eight lanes sum as one does")
{
    if (!can_run()) {
        UNIT_TRUE(1);
        return;
    }
    static double x[3 * 67], m[67], a[3 * 67 + 1], b[3 * 67];
    for (size_t n = 33; n <= 67; ++n)
        for (int soft = 0; soft < 2; ++soft) {
            double worst = 0;
            for (size_t i = 0; i < 3 * n; ++i) /* scattered enough */
                x[i] = fmod((double)(i + 1) * 0.6180339887498949, 1);
            for (size_t i = 0; i < n; ++i)
                m[i] = 1 + (double)(i % 3);
            struct gravity g = {.bodies = n,
                                .mass = m,
                                .k2 = 1,
                                .softening = soft ? 0.1 : 0,
                                .kernel = GRAVITY_AVX512,
                                .threads = 1};
            memset(a, 0, sizeof a);
            memset(b, 0, sizeof b);
            a[3 * n] = 77;
            gravity_add(&g, x, a);
            UNIT_EQUAL(a[3 * n], 77);
            g.kernel = GRAVITY_PORTABLE;
            gravity_add(&g, x, b);
            double size = 0;
            for (size_t i = 0; i < 3 * n; ++i)
                size = fmax(size, fabs(b[i]));
            for (size_t i = 0; i < 3 * n; ++i)
                worst = fmax(worst, fabs(a[i] - b[i]) / size);
            UNIT_NEAR(worst, 0, 1e-14); /* 67 roundings of 1e-16 */
        }
}

/* Single weights: the series leaves 6e-16, rounding a few more. */
TEST(test_weight, "the series makes up for the guess")
{
    UNIT_TRUE(1);
    if (!can_run())
        return;
    for (double s = 1e-20; s < 1e20; s *= 3.7) {
        const struct lanes w = weight8(set1(s), set1(2));
        const long double right = 2 / ((long double)s * sqrtl(s));
        for (int k = 0; k < 8; ++k)
            UNIT_NEAR(w.lane[k] / right - 1, 0, 2e-15);
    }
}
#else
TEST(test_lanes, "eight lanes sum as one does")
{
    UNIT_TRUE(1); /* no such kernel here */
}
TEST(test_weight, "the series makes up for the guess")
{
    UNIT_TRUE(1);
}
#endif
