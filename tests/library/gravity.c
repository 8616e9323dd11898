/* The sum over pairs: forces by hand, all kernels against long double,
   numbers of bodies that no vector divides, the same bits for any number
   of threads, Newton's third law, and energy as the force's potential. */
#include "unit.h"

#include "forces/gravity.h"
#include "toolbox/random.h"

#include <float.h>

enum { MOST = 700 };
static double place[3 * MOST], mass[MOST], sum[3 * MOST], other[3 * MOST];

static void scatter(size_t n, uint64_t seed)
{
    SEEDED(r, seed);
    for (size_t i = 0; i < 3 * n; ++i)
        place[i] = random_between(&r, -1, 1);
    for (size_t i = 0; i < n; ++i)
        mass[i] = random_between(&r, 0, 1);
}

static struct gravity prepare(size_t n, double k2, double softening)
{
    struct gravity g;
    UNIT_TRUE(gravity_create(&g, n, mass, k2, softening));
    UNIT_EQUAL(g.kernel, GRAVITY_AUTO);
    UNIT_EQUAL(g.threads, 1);
    return g;
}

/* A tree that takes no cell for one mass sums all pairs, too. */
static void choose(struct gravity *g, int kernel)
{
    g->kernel = (enum gravity_kernel)kernel;
    UNIT_TRUE(kernel != GRAVITY_TREE || gravity_use_tree(g, 0));
}

static void add(const struct gravity *g, double a[])
{
    memset(a, 0, 3 * g->bodies * sizeof a[0]);
    gravity_add(g, place, a);
}

/* Masses 2 and 3 at a distance of 5 = |(3, 4, 0)|, and with a softening of
   12, for which the root is 13. */
TEST(test_by_hand, "two bodies are as by hand")
{
    memcpy(place, (double[]){1, 4, 1, 5, 2, 2}, 6 * sizeof place[0]);
    mass[0] = 2, mass[1] = 3;
    FREED(gravity) g = prepare(2, 7, 0);
    for (int i = 0; i < 6; ++i)
        sum[i] = 100; /* it adds */
    gravity_add(&g, place, sum);
    UNIT_LIST(sum, 1e-13, 100 + 7 * 3 * 3. / 125, 100 - 7 * 2 * 3. / 125,
              100 + 7 * 3 * 4. / 125, 100 - 7 * 2 * 4. / 125);
    UNIT_EQUAL(sum[4], 100);
    UNIT_NEAR(gravity_potential(&g, place), -7 * 6 / 5., 1e-15 * 9);
    g.softening = 12;
    add(&g, sum);
    UNIT_NEAR(sum[0], 7 * 3 * 3. / 2197, 1e-17);
    UNIT_NEAR(gravity_potential(&g, place), -7 * 6 / 13., 1e-15 * 4);
    struct stepping_forces f = gravity_forces(&g);
    UNIT_EQUAL(f.size, 6);
    UNIT_TRUE(!f.damped);
    f.accelerate(f.what, place, NULL, other); /* it writes */
    UNIT_TRUE(memcmp(sum, other, 6 * sizeof sum[0]) == 0);
}

/* The largest error of sum[], by the sum of the sizes of what is added. */
static double worst_error(const struct gravity *g)
{
    const size_t n = g->bodies;
    double worst = 0;
    for (size_t i = 0; i < 3 * n; ++i) {
        long double right = 0, size = 0;
        for (size_t j = 0; j < n; ++j) {
            long double s = (long double)g->softening * g->softening;
            for (size_t k = 0; k < 3; ++k) {
                const long double d =
                    (long double)place[k * n + j] - place[k * n + i % n];
                s += d * d;
            }
            const long double d =
                (long double)place[i - i % n + j] - place[i];
            if (j == i % n)
                continue;
            const long double w = g->k2 * mass[j] / (s * sqrtl(s)) * d;
            right += w;
            size += fabsl(w);
        }
        if (size > 0)
            worst = fmax(worst, (double)(fabsl(sum[i] - right) / size));
    }
    return worst;
}

/* Rounding of a term, of n sums, and of the weight: (n + 10) epsilon. */
TEST(test_kernels, "all kernels sum right, whatever the number")
{
    static const size_t counts[] = {1,  2,  31, 32, 33, 34, 35,
                                    36, 37, 39, 40, 41, 64, 200};
    for (int kernel = 0; kernel < GRAVITY_KERNELS; ++kernel) {
        if (!gravity_can((enum gravity_kernel)kernel))
            continue;
        for (size_t c = 0; c < sizeof counts / sizeof counts[0]; ++c)
            for (int soft = 0; soft < 2; ++soft) {
                const size_t n = counts[c];
                scatter(n, 1 + c);
                FREED(gravity) g = prepare(n, 0.3, soft ? 0.2 : 0);
                choose(&g, kernel);
                sum[3 * n] = 77; /* nothing beyond the end is touched */
                add(&g, sum);
                UNIT_EQUAL(sum[3 * n], 77);
                UNIT_NEAR(worst_error(&g), 0,
                          ((double)n + 10) * DBL_EPSILON);
            }
    }
}

/* One body pulls, and the others weigh nothing: each acceleration is one
   term, right to 1e-14 at all distances from 1e-9 to 1e9. */
TEST(test_one_term, "a single pull is right to 1e-14")
{
    const size_t n = MOST;
    SEEDED(r, 5);
    for (int kernel = 0; kernel < GRAVITY_KERNELS; ++kernel) {
        if (!gravity_can((enum gravity_kernel)kernel))
            continue;
        memset(mass, 0, sizeof mass);
        memset(place, 0, sizeof place);
        mass[3] = 1;
        for (size_t i = 0; i < n; ++i)
            if (i != 3)
                place[i] = random_log_uniform(&r, 1e-9, 1e9);
        for (size_t i = 0; i < n; ++i) /* apart, for those without mass */
            place[n + i] = place[i] * (double)i;
        place[n + 3] = 0;
        struct gravity g = prepare(n, 1, 0);
        choose(&g, kernel);
        add(&g, sum);
        gravity_free(&g);
        double worst = 0;
        for (size_t i = 0; i < n; ++i)
            if (i != 3) {
                const long double x = place[i], y = place[n + i];
                const long double s = x * x + y * y;
                const long double right = -x / (s * sqrtl(s));
                worst = fmax(worst, (double)fabsl(sum[i] / right - 1));
            }
        UNIT_NEAR(worst, 0, 1e-14);
    }
}

/* What pulls at body i, one term after the other. */
static void add_plainly(const struct gravity *g, size_t i, double total[3])
{
    const size_t n = g->bodies;
    total[0] = total[1] = total[2] = 0;
    for (size_t j = 0; j < n; ++j) {
        double d[3], s;
        for (size_t k = 0; k < 3; ++k)
            d[k] = place[k * n + j] - place[k * n + i];
        s = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] +
            g->softening * g->softening;
        for (size_t k = 0; k < 3 && j != i; ++k)
            total[k] += g->mass[j] / (s * sqrt(s)) * d[k];
    }
}

TEST(test_blocks, "blocks have the bits of one body at a time")
{
    for (size_t n = 33; n <= 130; n += n < 70 ? 1 : 20)
        for (int soft = 0; soft < 2; ++soft) {
            scatter(n, n);
            struct gravity g = prepare(n, 0.3, soft ? 0.1 : 0);
            for (size_t i = 0; i < 3 * n; ++i)
                sum[i] = (double)i;
            gravity_add(&g, place, sum);
            for (size_t i = 0; i < n; ++i) {
                double total[3];
                add_plainly(&g, i, total);
                for (size_t k = 0; k < 3; ++k)
                    other[k * n + i] = (double)(k * n + i) + 0.3 * total[k];
            }
            UNIT_TRUE(memcmp(sum, other, 3 * n * sizeof sum[0]) == 0);
        }
}

TEST(test_threads, "any number of threads has the same bits")
{
    const size_t n = 501;
    scatter(n, 9);
    FREED(gravity) g = prepare(n, 1, 0.01);
    for (int kernel = 0; kernel < GRAVITY_KERNELS; ++kernel) {
        if (!gravity_can((enum gravity_kernel)kernel))
            continue;
        choose(&g, kernel);
        g.threads = 1;
        add(&g, sum);
        for (g.threads = 2; g.threads <= 7; ++g.threads) {
            add(&g, other);
            UNIT_TRUE(memcmp(sum, other, 3 * n * sizeof sum[0]) == 0);
        }
    }
}

/* Few bodies: all kernels are the same loop. */
TEST(test_few, "few bodies have the same bits in all kernels")
{
    scatter(32, 4);
    struct gravity g = prepare(32, 1, 0);
    add(&g, sum);
    for (int kernel = 1; kernel < GRAVITY_KERNELS; ++kernel) {
        g.kernel = (enum gravity_kernel)kernel;
        add(&g, other);
        UNIT_TRUE(memcmp(sum, other, 96 * sizeof sum[0]) == 0);
    }
}

TEST(test_third_law, "forces are opposite in pairs")
{
    static const size_t counts[] = {2, 3, 20, 33, 300};
    for (size_t c = 0; c < 5; ++c) {
        const size_t n = counts[c];
        scatter(n, 20 + c);
        struct gravity g = prepare(n, 1, 0.05);
        add(&g, sum);
        for (size_t k = 0; k < 3; ++k) {
            double total = 0, size = 0;
            for (size_t i = 0; i < n; ++i) {
                total += mass[i] * sum[k * n + i];
                size += fabs(mass[i] * sum[k * n + i]);
            }
            UNIT_NEAR(total / size, 0, 1e-13);
        }
    }
}

/* A body moved to and fro: minus force times way, to the second order that
   is left, 1e-10 of 1e-5 squared, and rounding of U, 1e-15 by 1e-5. */
TEST(test_potential, "the force is the slope of the potential")
{
    scatter(40, 6);
    struct gravity g = prepare(40, 2, 0.1);
    add(&g, sum);
    for (size_t i = 0; i < 120; i += 17) {
        const double h = 1e-5, x = place[i];
        place[i] = x + h;
        const double up = gravity_potential(&g, place);
        place[i] = x - h;
        const double down = gravity_potential(&g, place);
        place[i] = x;
        UNIT_NEAR(-(up - down) / (2 * h), mass[i % 40] * sum[i], 1e-6);
    }
}

/* In one place: no force with softening, not a number without. */
TEST(test_together, "softening keeps coincidence finite")
{
    memset(place, 0, sizeof place);
    mass[0] = mass[1] = 1;
    struct gravity g = prepare(2, 1, 0.1);
    add(&g, sum);
    UNIT_EQUAL(sum[0], 0);
    g.softening = 0;
    add(&g, sum);
    UNIT_TRUE(isnan(sum[0]));
}

/* Sources pull as bodies do whose mates have no mass; a share multiplies.
 */
TEST(test_sources, "none but the sources pull, by their share")
{
    const uint32_t source[] = {0, 7, 39};
    double share[40], all[40];
    scatter(40, 9);
    struct gravity g = prepare(40, 3, 0.05);
    memcpy(all, mass, sizeof all);
    for (size_t i = 0; i < 40; ++i) {
        share[i] = 1 + (double)(i % 2);
        if (i != 0 && i != 7 && i != 39)
            mass[i] = 0;
    }
    add(&g, other);
    memcpy(mass, all, sizeof all);
    g.source = source;
    g.sources = 3;
    g.factor = share;
    add(&g, sum);
    for (size_t c = 0; c < 120; ++c)
        UNIT_NEAR(sum[c], share[c % 40] * other[c],
                  1e-14 * (1 + fabs(sum[c])));
}

TEST(test_names, "kernels have names")
{
    UNIT_SAYS(gravity_kernels[GRAVITY_PORTABLE], "portable");
    UNIT_SAYS(gravity_kernels[GRAVITY_AUTO], "auto");
    UNIT_SAYS(gravity_kernels[GRAVITY_AVX512], "avx512");
    UNIT_SAYS(gravity_kernels[GRAVITY_TREE], "tree");
    UNIT_TRUE(!gravity_kernels[GRAVITY_KERNELS]);
    UNIT_TRUE(gravity_can(GRAVITY_PORTABLE));
    UNIT_TRUE(gravity_can(GRAVITY_AUTO) && gravity_can(gravity_fastest()));
    struct gravity g = prepare(32, 1, 0);
    UNIT_SAYS(gravity_summed_by(&g), "pairs");
    g = prepare(33, 1, 0);
    UNIT_SAYS(gravity_summed_by(&g), "portable");
    g.kernel = GRAVITY_AVX512;
    UNIT_SAYS(gravity_summed_by(&g), "avx512");
    g.source = (const uint32_t[]){3};
    UNIT_SAYS(gravity_summed_by(&g), "sources");
}
