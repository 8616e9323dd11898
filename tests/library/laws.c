/* The laws of equilibrium against reference values computed for this book
   (the velocity law by its gamma functions, checked by brute force; the
   positions by exact fractions), and the tests of a law against exact
   draws. Seeds are fixed; a tolerance is four standard deviations of what
   is measured, unless said otherwise. */
#include "unit.h"

#include "line/laws.h"
#include "line/statistics.h"
#include "toolbox/random.h"

#include <float.h>

enum { MOST = 100000 };
static double x[MOST];

static struct law law_of(const char *text)
{
    struct law law = {0};
    const char *wrong = laws_read(text, &law);
    UNIT_TRUE(wrong == NULL);
    laws_complete(&law, 0, 1);
    return law;
}

/* n velocities share E = 1/2, m = 1: u = v. p(0) and P(|u| < 0.1); ten
   digits are given. */
TEST(test_velocity_table, "the velocity law against its table")
{
    static const struct {
        const char *text;
        double n, top, inside;
    } table[] = {
        {"microcanonical:2,0.5,1", 2, 0.318309886184, 0.0637685609},
        {"microcanonical:3,0.5,1", 3, 0.5, 0.1},
        {"microcanonical:4,0.5,1", 4, 0.636619772368, 0.1271114284},
        {"microcanonical:5,0.5,1", 5, 0.75, 0.1495},
        {"microcanonical:8,0.5,1", 8, 1.018591635788, 0.2020283048},
        {"microcanonical:10,0.5,1", 10, 1.164104726615, 0.2301250001},
        {"microcanonical:22,0.5,1", 22, 1.806556253735, 0.3501563419},
        {"microcanonical:500,0.5,1", 500, 8.907231839338, 0.9748001361}};
    for (size_t i = 0; i < sizeof table / sizeof table[0]; ++i) {
        const struct law law = law_of(table[i].text);
        UNIT_NEAR(laws_density(&law, 0), table[i].top, 2e-11);
        UNIT_NEAR(laws_below(&law, 0.1) - laws_below(&law, -0.1),
                  table[i].inside, 1e-10);
        UNIT_NEAR(laws_sd(&law), 1 / sqrt(table[i].n), 1e-15);
        UNIT_EQUAL(laws_below(&law, 1), 1);
        UNIT_EQUAL(laws_below(&law, -1), 0);
        UNIT_EQUAL(laws_density(&law, 1.5), 0);
    }
}

/* Eight points between 1 and 10: means 2 to 9, these variances. */
TEST(test_positions, "positions: means and variances")
{
    static const double variance[] = {0.8, 1.4, 1.8, 2.0,
                                      2.0, 1.8, 1.4, 0.8};
    for (int k = 1; k <= 8; ++k) {
        char text[32];
        snprintf(text, sizeof text, "beta:%d,8,1,10", k);
        const struct law law = law_of(text);
        UNIT_NEAR(laws_mean(&law), k + 1, 1e-14);
        UNIT_NEAR(pow(laws_sd(&law), 2), variance[k - 1], 1e-14);
    }
    const struct law first = law_of("beta:1,8");
    UNIT_NEAR(laws_density(&first, 0), 8, 1e-13); /* N / L at the wall */
    UNIT_NEAR(laws_below(&first, 0.25), 1 - pow(0.75, 8), 1e-15);
}

/* Every density is the slope of its probability: a centred difference with
   h = 1e-4 errs by h^2 p''/6 < 1e-7, and its mean and spread are those of
   the formulas: 4000 strips. */
TEST(test_slopes, "a density is the slope of its probability")
{
    static const char *const texts[] = {
        "normal:3,2",    "microcanonical:5,6,0.5",
        "beta:3,8,1,10", "maxwell:2",
        "maxwell:2,3",   "maxwell:2,3,1",
        "maxwell:2,3,2", "maxwell:0.5,1,3"};
    for (size_t k = 0; k < sizeof texts / sizeof texts[0]; ++k) {
        const struct law law = law_of(texts[k]);
        const double mean = laws_mean(&law), sd = laws_sd(&law), h = 1e-4;
        double sum = 0, square = 0;
        for (double z = 0.05; z < 1; z += 0.3)
            UNIT_NEAR((laws_below(&law, mean + z * sd + h) -
                       laws_below(&law, mean + z * sd - h)) /
                          (2 * h),
                      laws_density(&law, mean + z * sd), 1e-7);
        for (int i = 0; i < 4000; ++i) {
            const double v = mean + (i + 0.5 - 2000) / 200 * sd;
            const double p = laws_below(&law, v + sd / 400) -
                             laws_below(&law, v - sd / 400);
            sum += p * v;
            square += p * (v - mean) * (v - mean);
        }
        UNIT_NEAR(sum, mean, 1e-4 * sd);
        UNIT_NEAR(sqrt(square), sd, 1e-4 * sd);
    }
}

/* The usual critical values: Kolmogorov 10, 5 and 1 %; chi-square of 19
   degrees of freedom, 5 and 1 %. Four or five digits are given. Both sums
   of Kolmogorov's function meet at 1. */
TEST(test_critical_values, "critical values of both tests")
{
    UNIT_NEAR(laws_kolmogorov(1.2238), 0.1, 5e-5);
    UNIT_NEAR(laws_kolmogorov(1.3581), 0.05, 5e-5);
    UNIT_NEAR(laws_kolmogorov(1.6276), 0.01, 5e-6);
    UNIT_NEAR(laws_kolmogorov(0.5), 0.9639452436648751, 1e-12);
    UNIT_NEAR(laws_kolmogorov(1 - 1e-14), laws_kolmogorov(1), 1e-12);
    UNIT_EQUAL(laws_kolmogorov(0), 1);
    UNIT_NEAR(laws_kolmogorov(0.05), 1, 1e-15);
    UNIT_NEAR(laws_chi2(30.1435, 19), 0.05, 5e-6);
    UNIT_NEAR(laws_chi2(36.1909, 19), 0.01, 2e-6);
}

/* One component of a random direction in n dimensions. */
static double draw_component(struct random *r, int n)
{
    const double first = random_normal(r);
    double square = first * first;
    for (int i = 1; i < n; ++i) {
        const double other = random_normal(r);
        square += other * other;
    }
    return first / sqrt(square);
}

/* If the law holds, a probability below p comes up with probability p:
   1000 tests of 400 exact draws each. */
TEST(test_true_law, "a true law passes as often as it should")
{
    enum { TIMES = 1000, SAMPLES = 400 };
    const struct law law = law_of("microcanonical:10,0.5,1");
    SEEDED(r, 41);
    int small[2] = {0, 0}, large[2] = {0, 0};
    for (int t = 0; t < TIMES; ++t) {
        struct law_test test;
        for (int i = 0; i < SAMPLES; ++i)
            x[i] = draw_component(&r, 10);
        UNIT_TRUE(laws_test(&law, SAMPLES, x, 1, 0, 0, &test));
        UNIT_TRUE(test.degrees == 19);
        small[0] += test.distance_probability < 0.1;
        small[1] += test.chi2_probability < 0.1;
        large[0] += test.distance_probability > 0.5;
        large[1] += test.chi2_probability > 0.5;
    }
    for (int k = 0; k < 2; ++k) {
        UNIT_NEAR(small[k], 0.1 * TIMES, 4 * sqrt(0.1 * 0.9 * TIMES));
        UNIT_NEAR(large[k], 0.5 * TIMES, 4 * sqrt(0.5 * 0.5 * TIMES));
    }
}

/* Normal numbers with the correlations phi^lag, of the variance 1. */
static void draw_series(struct random *r, double phi, size_t n)
{
    double value = random_normal(r);
    for (size_t i = 0; i < n; ++i) {
        x[i] = value;
        value = phi * value + sqrt(1 - phi * phi) * random_normal(r);
    }
}

/* Correlated samples of a true law, 400 times, in 64 blocks of 16 g. What
   is called chi-square has the mean and the variance 2 of the degrees that
   are measured with it. The blocks' ends lose up to g / 2 B = 1/32 of the
   scatter, and that of 64 blocks is known to sqrt(2 / 63 nu), which makes
   the mean of the quotient larger by 2/63. Of 400 probabilities 20 are
   below 0.05 and 200 below a half. (Divided by g, chi-square of phi = 0.9
   has the mean 2.9.) Independent ones have 19 degrees, of which 64 blocks
   of 16 are on average right, but for the part that is cut off at 19: their
   spread is nu / 32 = 0.6. */
TEST(test_correlated, "correlated samples need their inefficiency")
{
    enum { TIMES = 400 };
    const struct law law = law_of("normal:0,1");
    const double phis[] = {0, 0.5, 0.9};
    SEEDED(r, 43);
    for (int p = 0; p < 3; ++p) {
        const double g = (1 + phis[p]) / (1 - phis[p]);
        const size_t block = (size_t)ceil(16 * g), n = 64 * block;
        double sum = 0, square = 0, nu = 0;
        int low = 0, half = 0, distant = 0;
        for (int t = 0; t < TIMES; ++t) {
            struct law_test test;
            draw_series(&r, phis[p], n);
            UNIT_TRUE(laws_test(&law, n, x, g, block, 0, &test));
            const double more = test.chi2 - test.degrees;
            sum += more / TIMES;
            square += more * more / TIMES;
            nu += test.degrees / TIMES;
            low += test.chi2_probability < 0.05;
            half += test.chi2_probability < 0.5;
            distant += test.distance_probability < 0.05;
        }
        UNIT_NEAR(sum, 2.0 / 63 + nu / 64,
                  4 * sqrt(2 * nu / TIMES) + nu / 64);
        UNIT_NEAR(square / (2 * nu), 1,
                  4 * sqrt((2 + 12 / nu) / TIMES) + 0.1);
        UNIT_NEAR(low, 0.05 * TIMES, 4 * sqrt(0.05 * 0.95 * TIMES));
        UNIT_NEAR(half, 0.5 * TIMES, 4 * sqrt(0.5 * 0.5 * TIMES));
        UNIT_TRUE(distant < 0.05 * TIMES + 4 * sqrt(0.05 * 0.95 * TIMES));
        if (p == 0)
            UNIT_NEAR(nu, 19, 1);
    }
}

/* A law with two numbers from the samples: fewer degrees of freedom, and
   no probability of the distance. */
TEST(test_fitted, "fitted numbers cost degrees of freedom")
{
    SEEDED(r, 44);
    struct law law = {0};
    struct law_test test;
    for (int i = 0; i < 5000; ++i)
        x[i] = 7 + 3 * random_normal(&r);
    const struct statistics_moments m = statistics_moments(5000, x);
    UNIT_TRUE(!laws_read("normal", &law));
    const size_t fitted = laws_complete(&law, m.mean, sqrt(m.variance));
    UNIT_TRUE(laws_test(&law, 5000, x, 1, 0, fitted, &test));
    UNIT_TRUE(test.degrees == 17);
    UNIT_NEAR(test.chi2, 17, 4 * sqrt(2 * 17));
    UNIT_TRUE(isnan(test.distance_probability));
}
