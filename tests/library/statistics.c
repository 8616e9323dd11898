/* Histograms, fits and errors, held against sums done by hand and against
   series whose correlations are known: x' = phi x + noise has the
   correlations phi^lag and the inefficiency (1 + phi) / (1 - phi). Seeds
   are fixed; a tolerance is four standard deviations of what is measured,
   unless said otherwise. */
#include "unit.h"

#include "line/statistics.h"
#include "toolbox/random.h"

#include <float.h>

enum { MOST = 1 << 18 };
static double x[MOST], y[MOST];

/* Fills x with a series of variance 1 in its stationary state. */
static void correlated(struct random *r, double phi, size_t n, double out[])
{
    double value = random_normal(r);
    for (size_t i = 0; i < n; ++i) {
        out[i] = value;
        value = phi * value + sqrt(1 - phi * phi) * random_normal(r);
    }
}

static double inefficiency(double phi)
{
    return (1 + phi) / (1 - phi);
}

/* By hand: mean 5, squares of the deviations 32, cubes 42, fourth 356. */
static const double eight[] = {2, 4, 4, 4, 5, 5, 7, 9};

/* The differences of the shifted numbers are exact, and so is all else. The
   formula <x^2> - <x>^2 is off by 1e18 eps = 200. */
TEST(test_shifted_moments, "a large mean costs no digits")
{
    double shifted[8];
    for (int i = 0; i < 8; ++i)
        shifted[i] = eight[i] + 1e9;
    UNIT_NEAR(statistics_moments(8, shifted).variance, 32.0 / 7, 1e-14);
    /* a mean that is rounded, by 1/24, has to be corrected for */
    const double far[] = {1e15, 1e15, 1e15 + 1};
    UNIT_NEAR(statistics_moments(3, far).variance, 1.0 / 3, 1e-15);
}

TEST(test_edges, "edges and what is outside")
{
    struct statistics_histogram *h = statistics_histogram_create(-1, 3, 4);
    const double samples[] = {-1, 3,         3.0000001, -1.0000001,
                              0,  2.9999999, 1};
    for (size_t i = 0; i < sizeof samples / sizeof samples[0]; ++i)
        statistics_histogram_add(h, samples[i]);
    UNIT_TRUE(h->below == 1 && h->above == 1 && h->total == 7);
    UNIT_TRUE(h->count[0] == 1 && h->count[1] == 1);
    UNIT_TRUE(h->count[2] == 1 && h->count[3] == 2);
    UNIT_EQUAL(statistics_histogram_edge(h, 1), 0);
    UNIT_EQUAL(statistics_histogram_edge(h, 4), 3);
    UNIT_NEAR(statistics_histogram_density(h, 3), 2.0 / 7, DBL_EPSILON);
    free(h);
}

/* Nine of ten samples in one bin: p = 0.9. Four of four: p(1 - p) is that
   of 1/n with n = 4, or n = 2 if two are worth one. */
TEST(test_full_and_empty_bins, "full and empty bins have an error")
{
    struct statistics_histogram *h = statistics_histogram_create(0, 2, 2);
    for (int i = 0; i < 4; ++i)
        statistics_histogram_add(h, 0.5);
    for (size_t bin = 0; bin < 2; ++bin) {
        UNIT_NEAR(statistics_histogram_error(h, bin, 1),
                  sqrt(0.25 * 0.75 / 4), 1e-15);
        UNIT_NEAR(statistics_histogram_error(h, bin, 2),
                  sqrt(0.5 * 0.5 / 2), 1e-15);
    }
    for (int i = 0; i < 5; ++i)
        statistics_histogram_add(h, 0.5);
    statistics_histogram_add(h, 1.5);
    UNIT_NEAR(statistics_histogram_error(h, 0, 1), sqrt(0.9 * 0.1 / 10),
              1e-15);
    UNIT_NEAR(statistics_histogram_error(h, 1, 1), sqrt(0.9 * 0.1 / 10),
              1e-15);
    free(h);
}

/* Scott: 6 sigma / (3.49 sigma / 400^(1/3)) = 12.7. */
TEST(test_bins, "Scott's number of bins")
{
    UNIT_TRUE(statistics_bins(400, -3, 3, 1) == 13);
    UNIT_TRUE(statistics_bins(400, 0, 1, 0) == 1000);
    UNIT_TRUE(statistics_bins(2, 0, 1, 100) == 1);
}

/* Fits 500 histograms of 400 normal numbers in a range that cuts off a
   third of them. Returns the mean of ((fit - truth) / error)^2. */
static void fit_many(double low, double high, double square[2])
{
    enum { TIMES = 500, SAMPLES = 400 };
    SEEDED(r, 32);
    struct statistics_gaussian fit;
    square[0] = square[1] = 0;
    for (int k = 0; k < TIMES; ++k) {
        struct statistics_histogram *h =
            statistics_histogram_create(low, high, 12);
        for (int i = 0; i < SAMPLES; ++i)
            statistics_histogram_add(h, 3 + 2 * random_normal(&r));
        UNIT_TRUE(statistics_fit_gaussian(h, 1, &fit));
        square[0] += pow((fit.mean - 3) / fit.mean_error, 2) / TIMES;
        square[1] += pow((fit.sd - 2) / fit.sd_error, 2) / TIMES;
        free(h);
    }
}

/* The mean of 500 squares of standard normal numbers is 1 +- 0.063. */
TEST(test_fit, "fits scatter as they say, also in a part")
{
    double square[2];
    fit_many(-5, 11, square);
    UNIT_LIST(square, 4 * 0.063, 1, 1);
    fit_many(2, 11, square); /* a third of the samples is below */
    UNIT_LIST(square, 4 * 0.063, 1, 1);
}

/* With narrow bins the errors are sigma / sqrt(n) and sigma / sqrt(2 n):
   the bins' width of sigma / 20 adds 1/4800. Inefficiency 4 doubles them.
 */
TEST(test_fit_errors, "errors of a fit with narrow bins")
{
    SEEDED(r, 33);
    struct statistics_gaussian fit, worse;
    struct statistics_histogram *h =
        statistics_histogram_create(-12, 18, 300);
    for (int i = 0; i < 100000; ++i)
        statistics_histogram_add(h, 3 + 2 * random_normal(&r));
    UNIT_TRUE(statistics_fit_gaussian(h, 1, &fit));
    UNIT_TRUE(statistics_fit_gaussian(h, 4, &worse));
    UNIT_NEAR(fit.mean_error, fit.sd / sqrt(100000), 1e-3 * fit.mean_error);
    UNIT_NEAR(fit.sd_error, fit.sd / sqrt(200000), 1e-3 * fit.sd_error);
    UNIT_NEAR(worse.mean_error, 2 * fit.mean_error, 1e-12);
    UNIT_NEAR(fit.chi2, fit.degrees, 4 * sqrt(2 * (double)fit.degrees));
    UNIT_NEAR(worse.chi2, fit.chi2 / 4, 1e-9);
    free(h);
}

TEST(test_bad_fit, "a bad fit is seen, an impossible one refused")
{
    struct statistics_gaussian fit;
    struct statistics_histogram *h = statistics_histogram_create(0, 1, 10);
    for (int i = 0; i < 10000; ++i)
        statistics_histogram_add(h, (i + 0.5) / 10000);
    UNIT_TRUE(statistics_fit_gaussian(h, 1, &fit));
    UNIT_TRUE(fit.chi2 > 20 * (double)fit.degrees);
    UNIT_TRUE(fit.degrees == 9); /* ten bins, two ends, three conditions */
    free(h);
    h = statistics_histogram_create(0, 1, 10);
    for (int i = 0; i < 10; ++i)
        statistics_histogram_add(h, 0.55);
    UNIT_TRUE(!statistics_fit_gaussian(h, 1, &fit));
    free(h);
}

/* Phi(1) - Phi(0) = 0.34134474606854293, and far out on either side. */
TEST(test_gaussian_between, "Gaussian probabilities near and far")
{
    UNIT_NEAR(statistics_gaussian_between(3, 2, 3, 5), 0.34134474606854293,
              1e-16);
    UNIT_NEAR(statistics_gaussian_between(0, 1, 10, INFINITY) /
                  7.619853024160527e-24,
              1, 1e-13);
    UNIT_NEAR(statistics_gaussian_between(0, 1, -INFINITY, -10) /
                  7.619853024160527e-24,
              1, 1e-13);
    UNIT_EQUAL(statistics_gaussian_between(0, 2, 0, 0.04),
               statistics_gaussian_between(0, 2, -0.04, 0));
}

/* The error that is chosen, for series of five correlations, against the
   exact one: blocks and sums of correlations by four of their own
   uncertainties, and the blocks' bias of a quarter of it. */
TEST(test_errors, "errors of five known series")
{
    static const double phis[] = {-0.5, 0, 0.5, 0.9, 0.99};
    SEEDED(r, 35);
    for (int k = 0; k < 5; ++k) {
        const double g = inefficiency(phis[k]);
        const double exact = sqrt(g / MOST);
        struct statistics_blocking b;
        correlated(&r, phis[k], MOST, x);
        UNIT_TRUE(statistics_blocking(MOST, x, &b));
        UNIT_TRUE(b.plateau);
        UNIT_NEAR(b.error, exact, 4.25 * b.level[b.chosen].uncertainty);
        const struct statistics_correlation c =
            statistics_correlation(MOST, x);
        UNIT_TRUE(c.settled);
        UNIT_NEAR(c.inefficiency, g, 4 * c.uncertainty);
        UNIT_NEAR(c.error, exact, 4 * c.uncertainty / g / 2 * exact);
    }
}

/* Is the mean off by as much as it says? Over 400 series the mean square of
   mean / error is 1 +- 0.071 (and 1.035 for blocks of 128 with a bias of
   2 %); without blocking it is g = 19. */
TEST(test_coverage, "honest errors cover, naive ones do not")
{
    enum { TIMES = 400, SAMPLES = 1 << 15 };
    double honest = 0, naive = 0;
    SEEDED(r, 36);
    struct statistics_description d;
    for (int t = 0; t < TIMES; ++t) {
        correlated(&r, 0.9, SAMPLES, x);
        UNIT_TRUE(statistics_describe(SAMPLES, x, true, &d));
        honest += pow(d.mean / d.mean_error, 2) / TIMES;
        naive += pow(d.mean / d.naive_error, 2) / TIMES;
    }
    UNIT_NEAR(honest, 1.035, 4 * 0.071);
    UNIT_NEAR(naive, 19, 4 * 0.071 * 19);
}

/* A telegraph, which is 1 or -1 for 1024 values at a time: four of them say
   nothing sure of its mean, whatever its squares say, which are all alike.
   Of a list whose squares are correlated and whose values are not, the
   same. */
TEST(test_every_plateau, "all errors need a plateau")
{
    struct statistics_description d;
    SEEDED(r, 38);
    for (int i = 0; i < 4096; ++i)
        x[i] = i / 1024 % 2 ? -1 : 1;
    UNIT_TRUE(statistics_describe(4096, x, true, &d) && !d.plateau);
    UNIT_EQUAL(d.mean, 0);
    UNIT_EQUAL(d.sd, sqrt(4096 / 4095.0));
    for (int i = 0; i < 4096; ++i)
        x[i] = (random_uniform(&r) < 0.5 ? -1 : 1) * (i / 1024 % 2 ? 1 : 3);
    UNIT_TRUE(statistics_describe(4096, x, true, &d) && !d.plateau);
    for (int i = 0; i < 4096; ++i)
        x[i] = random_normal(&r);
    UNIT_TRUE(statistics_describe(4096, x, true, &d) && d.plateau);
    UNIT_TRUE(statistics_describe(4096, x, false, &d) && d.plateau);
}

TEST(test_no_plateau, "too short a run says so")
{
    SEEDED(r, 37);
    struct statistics_blocking b;
    for (int i = 0; i < 1000; ++i)
        x[i] = i;
    UNIT_TRUE(statistics_blocking(1000, x, &b) && !b.plateau);
    for (int t = 0; t < 20; ++t) {
        correlated(&r, 0.999, 400, x);
        UNIT_TRUE(statistics_blocking(400, x, &b) && !b.plateau);
    }
    for (int i = 0; i < 1000; ++i)
        x[i] = 7;
    UNIT_TRUE(statistics_blocking(1000, x, &b) && b.plateau);
    UNIT_EQUAL(b.error, 0);
    UNIT_EQUAL(b.inefficiency, 1);
}

/* The squares of a series of flips +-a, a slow: the mean looks perfect. */
TEST(test_squares_count, "the slow squares of a fast series count")
{
    SEEDED(r, 39);
    struct statistics_description d;
    correlated(&r, 0.99, MOST, y);
    for (int i = 0; i < MOST; ++i)
        x[i] = random_uniform(&r) < 0.5 ? y[i] : -y[i];
    UNIT_TRUE(statistics_describe(MOST, x, true, &d));
    /* <x'x'> squares have phi^2: g = (1 + .9801) / (1 - .9801) = 99.5 */
    UNIT_NEAR(d.inefficiency, 99.5, 4 * 99.5 * 2 / sqrt(2 * 63));
    UNIT_NEAR(d.mean_error, sqrt(1.0 / MOST), 0.2 * d.mean_error);
    /* and the other way round: the series has 19, its squares 9.5 */
    correlated(&r, 0.9, MOST, x);
    UNIT_TRUE(statistics_describe(MOST, x, true, &d));
    UNIT_NEAR(d.inefficiency, 19, 4 * 19 * 2 / sqrt(2 * 255));
}

/* By hand: five blocks, the mean of every cell 2, variances 1, 1 and 0 and
   the covariance -1; over 2 they are 1/2. The trace is 1, that of the
   square 1, of which (16/18) (1 - 1/4) = 2/3 is left. Of three blocks less
   than the bound is left: two degrees are the most. */
TEST(test_scatter, "the scatter of counts, by hand")
{
    const double count[] = {3, 1, 2, 1, 3, 2, 3, 1, 2, 1, 3, 2, 2, 2, 2};
    const struct statistics_scatter s = statistics_scatter(5, 3, count, 2);
    UNIT_NEAR(s.scale, 2.0 / 3, 1e-15);
    UNIT_NEAR(s.degrees, 1.5, 1e-15);
    const struct statistics_scatter few =
        statistics_scatter(3, 3, count, 2);
    UNIT_NEAR(few.degrees, 2, 1e-15);
    const double alike[] = {1, 3, 2, 1, 3, 2, 1, 3, 2};
    const struct statistics_scatter none =
        statistics_scatter(3, 3, alike, 2);
    UNIT_EQUAL(none.scale, 1);
    UNIT_EQUAL(none.degrees, 2);
}

/* What all counts have in common does not count. Fifths of 1e9 are rounded
   by 1e-7. */
TEST(test_large_counts, "large counts scatter as small ones")
{
    double count[] = {3, 1, 2, 1, 3, 2, 3, 1, 2, 1, 3, 2, 3, 2, 3};
    const struct statistics_scatter few =
        statistics_scatter(5, 3, count, 2);
    for (size_t i = 0; i < 15; ++i)
        count[i] += 1e9;
    const struct statistics_scatter many =
        statistics_scatter(5, 3, count, 2);
    UNIT_NEAR(many.scale, few.scale, 1e-5 * few.scale);
    UNIT_NEAR(many.degrees, few.degrees, 1e-5 * few.degrees);
}

/* Eighths, which any power of two leaves without rounding down to 2^-1060,
   and what is said of them. */
enum { SCALED = 4096 };
/* The place in b of what p points at in a. */
#define AT(p)                                                              \
    ((const double *)((const char *)(p) - (const char *)&a +               \
                      (const char *)&b))
struct said {
    struct statistics_moments m;
    struct statistics_description d;
    struct statistics_blocking b;
    struct statistics_correlation c;
    struct statistics_gaussian g;
    struct statistics_dependence p;
    double covariance, density, error;
};

static struct said say(int power, struct said *s)
{
    static double u[SCALED], v[SCALED];
    SEEDED(r, 31);
    correlated(&r, 0.5, SCALED, u);
    correlated(&r, 0.2, SCALED, v);
    for (size_t i = 0; i < SCALED; ++i) {
        u[i] = ldexp(round(8 * u[i]) / 8, power);
        v[i] = ldexp(round(8 * v[i]) / 8, power);
    }
    s->m = statistics_moments(SCALED, u);
    UNIT_TRUE(statistics_describe(SCALED, u, true, &s->d));
    UNIT_TRUE(statistics_blocking(SCALED, u, &s->b));
    s->c = statistics_correlation(SCALED, u);
    s->covariance = statistics_covariance(SCALED, u, s->m.mean, 1);
    UNIT_TRUE(statistics_dependence(SCALED, u, v, 5, true, &s->p));
    struct statistics_histogram *h =
        statistics_histogram_create(ldexp(-3, power), ldexp(3, power), 24);
    for (size_t i = 0; i < SCALED; ++i)
        statistics_histogram_add(h, u[i]);
    UNIT_TRUE(statistics_fit_gaussian(h, s->d.inefficiency, &s->g));
    s->density = statistics_histogram_density(h, 12);
    s->error = statistics_histogram_error(h, 12, s->d.inefficiency);
    free(h);
    return *s;
}

/* Another unit of length changes no digit: each number is the one of the
   same samples at scale 1 times a power of the scale, rounded once where it
   falls below 2^-1022, infinite where no number is as large. */
TEST(test_scales, "any scale that numbers hold")
{
    static struct said a, b;
    say(0, &a);
    static const int powers[] = {-1060, -1000, -539, -270, -130, 1,
                                 130,   260,   540,  664,  1019};
    for (size_t i = 0; i < sizeof powers / sizeof powers[0]; ++i) {
        const int k = powers[i];
        const double *of[] = {&a.m.mean,       &a.m.least,
                              &a.m.greatest,   &a.d.least,
                              &a.d.greatest,   &a.d.mean,
                              &a.d.mean_error, &a.d.sd,
                              &a.d.sd_error,   &a.d.naive_error,
                              &a.b.error,      &a.b.level[3].error,
                              &a.c.error,      &a.b.level[3].uncertainty,
                              &a.g.mean,       &a.g.sd,
                              &a.g.mean_error, &a.g.sd_error};
        const double *same[] = {&a.d.kurtosis,     &a.d.kurtosis_error,
                                &a.d.inefficiency, &a.b.inefficiency,
                                &a.c.inefficiency, &a.c.uncertainty,
                                &a.g.chi2,         &a.p.correlation,
                                &a.p.error,        &a.p.chi2};
        say(k, &b);
        for (size_t n = 0; n < sizeof of / sizeof of[0]; ++n)
            UNIT_EQUAL(*AT(of[n]), ldexp(*of[n], k));
        for (size_t n = 0; n < sizeof same / sizeof same[0]; ++n)
            UNIT_EQUAL(*AT(same[n]), *same[n]);
        UNIT_TRUE(b.m.variance == ldexp(a.m.variance, 2 * k));
        UNIT_TRUE(b.covariance == ldexp(a.covariance, 2 * k));
        UNIT_TRUE(b.m.third == ldexp(a.m.third, 3 * k));
        UNIT_TRUE(b.m.fourth == ldexp(a.m.fourth, 4 * k));
        UNIT_TRUE(b.density == ldexp(a.density, -k));
        UNIT_TRUE(b.error == ldexp(a.error, -k));
        UNIT_TRUE(b.d.plateau == a.d.plateau && b.d.block == a.d.block);
    }
    /* Found by a trial of the second edition: the sum overflowed. */
    const double wide[] = {1e308, -1e308, 1e308};
    UNIT_NEAR(statistics_moments(3, wide).mean, 1e308 / 3, 1e293);
}
