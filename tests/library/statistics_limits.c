/* Series and counts so small or so regular that all is known of them by
   hand; arrays are no longer than they have to be. */
#include "unit.h"

#include "line/laws.h"
#include "line/statistics.h"

#include <float.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/* The same numbers in memory that ends behind them. */
static double *copy_of(size_t n, const double x[])
{
    double *copy = malloc(n * sizeof *copy);
    UNIT_MUST(copy);
    memcpy(copy, x, n * sizeof *copy);
    return copy;
}

/* Does one of the things that are required not to be done. */
static void breach(int which)
{
    static const double range[][3] = {/* low, high, bins */
                                      {1, 1, 3},
                                      {2, 1, 3},
                                      {-DBL_MAX, DBL_MAX, 3},
                                      {1, 2, 0}};
    if (which < 4)
        free(statistics_histogram_create(range[which][0], range[which][1],
                                         (size_t)range[which][2]));
    if (which == 4)
        statistics_moments(1, (const double[]){1});
    if (which == 5)
        statistics_covariance(2, (const double[]){1, 2}, 1.5, 2);
    if (which == 6)
        laws_density(&(struct law){.kind = LAW_NORMAL, .given = 1}, 0);
    if (which == 7)
        laws_below(&(struct law){.kind = LAW_BETA, .given = 2}, 0);
}

/* An assertion ends the process. */
TEST(test_asserts, "what is required is asserted")
{
    for (int which = 0; which < 8; ++which) {
        int status = 0;
        fflush(NULL);
        const pid_t child = fork();
        if (child == 0) {
            setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
            close(STDERR_FILENO);
            breach(which);
            _exit(0);
        }
        UNIT_TRUE(child > 0 && waitpid(child, &status, 0) == child &&
                  WIFSIGNALED(status));
    }
    const struct statistics_moments m =
        statistics_moments(2, (const double[]){1, 3});
    UNIT_EQUAL(m.mean, 2);
    UNIT_EQUAL(m.variance, 2);
}

/* The power of two at or below the largest, as far as there is one whose
   inverse is a number. */
TEST(test_unit, "units are powers of two")
{
    static const struct {
        double x[3], unit;
    } units[] = {{{1, 0, 0}, 1},
                 {{0, -1.99, 1}, 1},
                 {{0.1, 1, -2}, 2},
                 {{0, 0, 0}, 1},
                 {{0, 0.3, 0}, 0.25},
                 {{DBL_MAX, 1, 0}, 0x1p1022},
                 {{0, 0, 0x1p-1060}, 0x1p-1022}};
    for (size_t i = 0; i < sizeof units / sizeof units[0]; ++i) {
        double *x = copy_of(3, units[i].x);
        UNIT_EQUAL(statistics_unit(3, x), units[i].unit);
        free(x);
    }
}

enum { LENGTH = 4096 };

/* A series whose squared errors, from blocks of 1, 2, 4, ... samples, stand
   to the first like share[0] = 1, share[1], ...: a sum of square waves. A
   wave that changes its sign every 2^k samples counts in blocks of up to
   that length and is lost in longer ones, and no two waves have a product
   on average. With the amplitudes a_k the variance of blocks of 2^k samples
   is the sum of the a^2 from k on, times n / (n - 1) for n blocks. */
static void waves(size_t n, size_t levels, const double share[], double x[])
{
    double rest[16] = {0};
    for (size_t k = 0; k < levels; ++k)
        rest[k] = share[k] * ((double)(n >> k) - 1) / ((double)n - 1);
    for (size_t i = 0; i < n; ++i) {
        x[i] = 0;
        for (size_t k = 0; k < levels; ++k)
            x[i] += (i >> k) % 2 ? -sqrt(rest[k] - rest[k + 1])
                                 : sqrt(rest[k] - rest[k + 1]);
    }
}

/* The length of the blocks (eq:choice): the first with B^3 >= 2 n g^2, or
   the one with the largest error before that; a later one if its error is
   more than its uncertainty above and there are 64 blocks; none of less
   than 16 blocks counts. 2 n is 8192, and B^3 is 8^k. */
TEST(test_choice, "the length of blocks is that of the rule")
{
    static const struct {
        size_t n, levels;
        double share[12];
        size_t chosen;
        bool plateau;
    } rules[] = {
        /* 8^5 / 8192 = 2^2 */
        {4096, 9, {1, 1.2, 1.4, 1.6, 1.8, 1.95, 1.95, 1.95, 1.95}, 5, true},
        {4096, 9, {1, 1.2, 1.4, 1.6, 1.8, 2.05, 2.05, 2.05, 2.05}, 6, true},
        /* (1 - 1 / sqrt(2 63))^-2 = 1.205 */
        {4096, 9, {1, 1.2, 1.4, 1.5, 1.5, 1.5, 1.83, 1.83, 1.83}, 6, true},
        {4096, 9, {1, 1.2, 1.4, 1.5, 1.5, 1.5, 1.78, 1.78, 1.78}, 5, true},
        /* 32 and, of 3072, 48 blocks are too few for that */
        {4096, 9, {1, 1.2, 1.4, 1.5, 1.5, 1.5, 1.5, 2.6, 2.6}, 5, true},
        {3072, 9, {1, 1.2, 1.4, 1.5, 1.5, 1.5, 2.4, 2.4, 2.4}, 5, true},
        /* 8^8 / 8192 = 45.25^2, of 16 blocks */
        {4096, 9, {1, 1.6, 2.6, 4.1, 6.6, 10.5, 16.8, 26.8, 44.5}, 8, true},
        {4096, 9, {1, 1.6, 2.6, 4.1, 6.6, 10.5, 16.8, 26.8, 46}, 8, false},
        /* of 3840 there are 15 of them, and 30 of the length before */
        {3840,
         9,
         {1, 1.6, 2.6, 4.1, 6.6, 10.5, 16.8, 26.8, 44.5},
         7,
         false},
        /* before the plateau the largest counts, at it even a smaller one
         */
        {4096, 9, {1, .5, .5, .4, .45, .45, .45, .45, .45}, 4, true},
        {32, 2, {1, .9}, 0, false},
        {32, 2, {1, 1.1}, 1, false},
        /* two samples, and blocks that are too few from the first on */
        {2, 1, {1}, 0, false},
        {15, 1, {1}, 0, false}};
    for (size_t r = 0; r < sizeof rules / sizeof rules[0]; ++r) {
        static double x[LENGTH];
        struct statistics_blocking b;
        const size_t n = rules[r].n, k = rules[r].chosen;
        waves(n, rules[r].levels, rules[r].share, x);
        if (n < 16)
            x[1] = 2;
        double *copy = copy_of(n, x);
        UNIT_TRUE(statistics_blocking(n, copy, &b));
        free(copy);
        /* The mean of 15 blocks is a 15th of a wave: 1/225 of its square.
         */
        const double odd = n % 512 ? 3e-3 : 1e-12;
        size_t levels = 0;
        while (n >> levels >= 2)
            ++levels;
        UNIT_EQUAL(b.levels, levels);
        for (size_t l = 0; l < rules[r].levels && n >= 16; ++l) {
            UNIT_EQUAL(b.level[l].blocks, n >> l);
            UNIT_EQUAL(b.level[l].length, 1 << l);
            UNIT_NEAR(b.level[l].error,
                      b.level[0].error * sqrt(rules[r].share[l]),
                      odd * b.level[l].error);
        }
        UNIT_EQUAL(b.chosen, k);
        UNIT_TRUE(b.plateau == rules[r].plateau);
        UNIT_NEAR(b.inefficiency, rules[r].share[k], 50 * odd);
        UNIT_EQUAL(b.error, b.level[k].error);
    }
    /* An odd sample is left out: blocks of 1 and 2, and of 3 and 5. */
    struct statistics_blocking b;
    UNIT_TRUE(statistics_blocking(5, (const double[]){1, 2, 3, 5, 99}, &b));
    UNIT_EQUAL(b.levels, 2);
    UNIT_EQUAL(b.level[1].error, 1.25);
    UNIT_NEAR(b.level[1].uncertainty, 1.25 / sqrt(2), 1e-15);
}

/* The sums of the correlations, term by term. */
static void correlations(size_t n, const double x[])
{
    double mean = 0, rho[64], g = 1;
    for (size_t i = 0; i < n; ++i)
        mean += x[i] / (double)n;
    for (size_t lag = 0; lag <= n / 8; ++lag) {
        rho[lag] = 0;
        for (size_t i = lag; i < n; ++i)
            rho[lag] += (x[i] - mean) * (x[i - lag] - mean);
        rho[lag] /= (double)(n - lag);
    }
    size_t window = 0;
    bool settled = false;
    for (size_t w = 1; w <= n / 8 && !settled; ++w) {
        window = w;
        g += 2 * rho[w] / rho[0];
        settled = (double)w >= 6 && (double)w >= 3 * g;
    }
    const double lags = 2 * (double)window + 1, count = (double)n;
    const double expected = fmax(0, g * (1 + lags / count));
    double *copy = copy_of(n, x);
    const struct statistics_correlation c = statistics_correlation(n, copy);
    UNIT_NEAR(statistics_covariance(n, copy, mean, 1), rho[1],
              1e-13 * rho[0]);
    free(copy);
    UNIT_EQUAL(c.window, window);
    UNIT_TRUE(c.settled == settled);
    UNIT_NEAR(c.inefficiency, expected, 1e-12);
    UNIT_NEAR(c.uncertainty, expected * sqrt(2 * lags / count), 1e-12);
    UNIT_NEAR(c.error, sqrt(rho[0] * expected / count), 1e-12);
}

/* Noise, its sums, its differences, which are less than independent, and a
   slope, which is never at its end. */
TEST(test_correlations, "sums of correlations, term by term")
{
    uint64_t state = 1;
    size_t none = 0;
    for (int series = 0; series < 80; ++series) {
        double x[500], last = 0;
        const size_t n = series % 4 ? 49 + 3 * (size_t)series : 500;
        for (size_t i = 0; i < n; ++i) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            const double u = (double)(state >> 33) * 0x1p-31 - 0.5;
            x[i] = series % 4 == 0   ? u
                   : series % 4 == 1 ? (last = 0.7 * last + u)
                   : series % 4 == 2 ? u - last
                                     : (double)i + u;
            last = series % 4 == 2 ? u : last;
        }
        if (series % 4 == 2)
            none += statistics_correlation(n, x).inefficiency == 0;
        correlations(n, x);
    }
    UNIT_TRUE(none > 0); /* what is below zero is none */
    static const double same[] = {3, 3, 3, 3, 3, 3, 3, 3};
    const struct statistics_correlation c = statistics_correlation(8, same);
    UNIT_TRUE(c.settled && c.window == 0);
    UNIT_EQUAL(c.inefficiency, 1 + 1.0 / 8);
    UNIT_EQUAL(c.error, 0);
}

/* Deviations -3, -1, -1, -1, 0, 0, 2, 4 from the mean 5: squares 32, fourth
   powers 356. The squares differ from their mean 4 by 5, -3, -3, -3, -4,
   -4, 0, 12, whose squares are 228. */
TEST(test_described, "eight numbers described by hand")
{
    static const double eight[] = {2, 4, 4, 4, 5, 5, 7, 9};
    struct statistics_description d;
    double *x = copy_of(8, eight);
    UNIT_TRUE(statistics_describe(8, x, false, &d));
    const double v = 32 / 7.0, k = 356 / 8.0 / (v * v);
    UNIT_EQUAL(d.n, 8);
    UNIT_EQUAL(d.least, 2);
    UNIT_EQUAL(d.greatest, 9);
    UNIT_EQUAL(d.mean, 5);
    UNIT_NEAR(d.sd, sqrt(v), 1e-15);
    UNIT_NEAR(d.kurtosis, k, 1e-14);
    UNIT_NEAR(d.naive_error, sqrt(v / 8), 1e-15);
    UNIT_NEAR(d.mean_error, sqrt(v / 8), 1e-15);
    UNIT_NEAR(d.sd_error, sqrt(228 / 7.0 / 8) / (2 * sqrt(v)), 1e-15);
    UNIT_EQUAL(d.inefficiency, 1);
    UNIT_EQUAL(d.block, 0);
    UNIT_TRUE(d.plateau);
    double added[8], mean = 0, square = 0;
    for (size_t i = 0; i < 8; ++i) {
        const double u = eight[i] - 5;
        added[i] = pow(u, 4) / (v * v) - 2 * k / v * u * u -
                   4 * (42 / 8.0) / (v * v) * u;
        mean += added[i] / 8;
    }
    for (size_t i = 0; i < 8; ++i)
        square += (added[i] - mean) * (added[i] - mean);
    UNIT_NEAR(d.kurtosis_error, sqrt(square / 7 / 8), 1e-14);
    free(x);
    static const double same[] = {7, 7};
    UNIT_TRUE(statistics_describe(2, same, true, &d));
    UNIT_EQUAL(d.sd, 0);
    UNIT_EQUAL(d.kurtosis, 0);
    UNIT_EQUAL(d.sd_error, 0);
    UNIT_EQUAL(d.kurtosis_error, 0);
    UNIT_TRUE(d.plateau);
}

/* The longest block that any of the three errors needs is said; here the
   first one's (see test_choice), or that of the squares alone. */
TEST(test_longest_block, "the longest block counts")
{
    static const double share[] = {1,    1.2,  1.4,  1.6, 1.8,
                                   2.05, 2.05, 2.05, 2.05};
    static double x[LENGTH];
    struct statistics_description d;
    struct statistics_blocking b;
    waves(LENGTH, 9, share, x);
    UNIT_TRUE(statistics_blocking(LENGTH, x, &b));
    UNIT_TRUE(statistics_describe(LENGTH, x, true, &d));
    UNIT_EQUAL(d.mean_error, b.error);
    UNIT_TRUE(d.block >= 64);
    UNIT_TRUE(d.inefficiency >= 2.05 - 1e-11);
    /* A sign that changes with each sample, and sizes that do every 64: in
       blocks of 64 g is 65, and 64^3 < 2 n g^2. */
    for (size_t i = 0; i < LENGTH; ++i)
        x[i] = (i % 2 ? -1 : 1) * (i / 64 % 2 ? 1 : 1.5);
    UNIT_TRUE(statistics_describe(LENGTH, x, true, &d));
    UNIT_EQUAL(d.block, 128);
}

/* Counts by hand: at either end bins are joined until 5 are expected, and
   the last takes the rest. */
static void chi2_of(const struct statistics_histogram *h, double g)
{
    struct statistics_gaussian fit;
    UNIT_TRUE(statistics_fit_gaussian(h, g, &fit));
    const double n = (double)h->total;
    double chi2 = 0, from = -INFINITY, found = 0;
    size_t groups = 0;
    for (size_t i = 0; i <= h->bins + 1; ++i) {
        const double to =
            i <= h->bins ? statistics_histogram_edge(h, i) : INFINITY;
        found += (double)(i == 0         ? h->below
                          : i <= h->bins ? h->count[i - 1]
                                         : h->above);
        const double p =
            statistics_gaussian_between(fit.mean, fit.sd, from, to);
        const double rest =
            statistics_gaussian_between(fit.mean, fit.sd, to, INFINITY);
        if (to == INFINITY || (n * p >= 5 && n * rest >= 5)) {
            chi2 += (found - n * p) * (found - n * p) / (n * p);
            found = 0;
            from = to;
            ++groups;
        }
    }
    UNIT_NEAR(fit.chi2, chi2 / g, 1e-9 * chi2);
    UNIT_EQUAL(fit.degrees, groups > 3 ? (double)groups - 3 : 0);
}

TEST(test_grouped, "bins are joined where little is expected")
{
    static const uint64_t counts[][10] = {
        {1, 2, 5, 9, 14, 13, 8, 5, 2, 1},
        {0, 3, 4, 7, 9, 11, 6, 6, 3, 0},
        {2, 2, 2, 3, 3, 3, 3, 2, 2, 2},
        {40, 60, 80, 90, 95, 93, 80, 66, 40, 20},
        {0, 0, 1, 3, 4, 3, 1, 0, 0, 0},
        {0, 0, 0, 0, 9, 9, 1, 0, 0, 0}};
    for (size_t c = 0; c < sizeof counts / sizeof counts[0]; ++c)
        for (uint64_t out = 0; out < 4; ++out) {
            struct statistics_histogram *h =
                statistics_histogram_create(-1, 3, 10);
            UNIT_MUST(h);
            h->below = out % 2 * 3;
            h->above = out / 2 * 4;
            h->total = h->below + h->above;
            for (size_t i = 0; i < 10; ++i) {
                h->count[i] = counts[c][i];
                h->total += counts[c][i];
            }
            if (c < 5 || out == 0)
                chi2_of(h, 1 + (double)out / 2);
            free(h);
        }
    struct statistics_gaussian fit;
    struct statistics_histogram *h = statistics_histogram_create(0, 1, 3);
    UNIT_TRUE(!statistics_fit_gaussian(h, 1, &fit));
    h->above = h->total = 5;
    UNIT_TRUE(!statistics_fit_gaussian(h, 1, &fit));
    free(h);
}

/* Six pairs in two by two cells: three in the lower row, of which two are
   in the lower column. 1.5 are expected in each. */
TEST(test_pairs, "six pairs by hand")
{
    static const double a[] = {1, 2, 3, 4, 5, 6}, b[] = {1, 9, 2, 8, 3, 7};
    struct statistics_dependence d;
    double *x = copy_of(6, a), *y = copy_of(6, b);
    UNIT_TRUE(statistics_dependence(6, x, y, 2, false, &d));
    UNIT_NEAR(d.chi2, 4 * 0.25 / 1.5, 1e-15);
    UNIT_EQUAL(d.degrees, 1);
    UNIT_TRUE(statistics_dependence(6, x, y, 3, false, &d));
    /* Of nine cells, two thirds expected, four have one and one has two. */
    UNIT_NEAR(d.chi2, (4 + 16 + 4 * 4) / 9.0 * 1.5, 1e-14);
    UNIT_EQUAL(d.degrees, 4);
    /* sum of (x - 3.5)(y - 5) = 9, of squares 17.5 and 58 */
    UNIT_NEAR(d.correlation, 9 / sqrt(17.5 * 58) * 5 / 6, 1e-15);
    double square = 0;
    for (size_t i = 0; i < 6; ++i)
        square += pow((a[i] - 3.5) * (b[i] - 5) / sqrt(17.5 / 5 * 58 / 5) -
                          d.correlation,
                      2);
    UNIT_NEAR(d.error, sqrt(square / 5 / 6), 1e-15);
    for (size_t i = 0; i < 6; ++i)
        y[i] = 4;
    UNIT_TRUE(!statistics_dependence(6, x, y, 2, false, &d));
    UNIT_TRUE(!statistics_dependence(6, y, x, 2, false, &d));
    UNIT_EQUAL(d.correlation, 0);
    free(x);
    free(y);
}
