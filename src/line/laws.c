/* Computes normal, Beta and Maxwell laws with the functions of GSL. */
#include "line/laws.h"

#include "line/statistics.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

/* For each law: its name, its syntax for error messages, and the smallest
   and largest number of parameters. */
static const struct {
    const char *name, *form;
    size_t fewest, most;
} kinds[] = {
    {"normal", "normal or normal:mean,sd", 0, 2},
    {"microcanonical",
     "microcanonical:n or microcanonical:n,E,m with whole n > 1", 1, 3},
    {"beta", "beta:k,n or beta:k,n,low,high with k from 1 to n", 2, 4},
    {"maxwell", "maxwell:kT, maxwell:kT,m or maxwell:kT,m,d", 1, 3}};

/* Returns whether x is a whole number from low to high. */
static bool whole(double x, double low, double high)
{
    return x >= low && x <= high && x == floor(x);
}

static bool makes_sense(const struct law *law)
{
    const double *p = law->parameter;
    const size_t given = law->given;
    switch (law->kind) {
    case LAW_NORMAL: return given < 2 || p[1] > 0;
    case LAW_MICROCANONICAL:
        return whole(p[0], 2, 1e9) && (given < 3 || fmin(p[1], p[2]) > 0);
    case LAW_BETA:
        return whole(p[1], 1, 1e9) && whole(p[0], 1, p[1]) &&
               (given < 4 || p[2] < p[3]);
    case LAW_MAXWELL:
        return given > 0 && p[0] > 0 && (given < 2 || p[1] > 0) &&
               (given < 3 || whole(p[2], 1, 100));
    }
    return false;
}

/* Reads a colon and numbers separated by commas. Returns false if the text
   is wrong. The optional numbers must be given all or not at all: a low end
   without a high end is an error. Maxwell's law is an exception, as each of
   its numbers makes sense without those after it. */
static bool read_numbers(const char *text, struct law *law)
{
    for (law->given = 0; *text; ++law->given) {
        char *end;
        if (law->given == kinds[law->kind].most ||
            *text != (law->given ? ',' : ':'))
            return false;
        law->parameter[law->given] = strtod(text + 1, &end);
        if (end == text + 1 || !isfinite(law->parameter[law->given]))
            return false;
        text = end;
    }
    return (law->given == kinds[law->kind].fewest ||
            law->given == kinds[law->kind].most ||
            law->kind == LAW_MAXWELL) &&
           makes_sense(law);
}

const char *laws_read(const char *text, struct law *law)
{
    const size_t length = strcspn(text, ":");
    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; ++k)
        if (strlen(kinds[k].name) == length &&
            strncmp(text, kinds[k].name, length) == 0) {
            law->kind = (enum law_kind)k;
            return read_numbers(text + length, law) ? NULL : kinds[k].form;
        }
    return "normal, microcanonical:n, beta:k,n or maxwell:kT";
}

size_t laws_complete(struct law *law, double mean, double sd)
{
    const size_t given = law->given;
    double *p = law->parameter;
    /* A row for each law, in the order of enum law_kind. */
    const double usual[][LAW_PARAMETERS] = {
        {mean, sd},
        {0, p[0] * sd * sd / 2, 1}, /* <v^2> = 2E/(nm) */
        {0, 0, 0, 1},
        {0, 1, 0}}; /* d = 0: law of a component, not of a speed */
    law->given = kinds[law->kind].most;
    for (size_t k = given; k < law->given; ++k)
        p[k] = usual[law->kind][k];
    if (law->kind == LAW_NORMAL)
        return 2 - given;
    return law->kind == LAW_MICROCANONICAL && given == 1 ? 1 : 0;
}

/* The law of low + (high - low) X, where X is a Beta(a,b) variate. */
struct stretched {
    double a, b, low, high;
};

/* Returns a microcanonical or Beta law as a stretched Beta law. In the
   microcanonical law of a velocity a = b (3.5, eq:velocity-cdf). */
static struct stretched beta_of(const struct law *law)
{
    const double *p = law->parameter;
    if (law->kind == LAW_BETA)
        return (struct stretched){p[0], p[1] + 1 - p[0], p[2], p[3]};
    const double fastest = sqrt(2 * p[1] / p[2]), a = (p[0] - 1) / 2;
    return (struct stretched){a, a, -fastest, fastest};
}

static double stretched_density(struct stretched s, double x)
{
    const double place = (x - s.low) / (s.high - s.low);
    /* gsl_ran_beta_pdf returns 0 outside [0,1]. */
    return gsl_ran_beta_pdf(place, s.a, s.b) / (s.high - s.low);
}

static double stretched_below(struct stretched s, double x)
{
    const double place = (x - s.low) / (s.high - s.low);
    return place <= 0   ? 0
           : place >= 1 ? 1
                        : gsl_cdf_beta_P(place, s.a, s.b);
}

/* Maxwell's density of a speed x is the density of a velocity component at
   x times a number proportional to x^(d-1), the surface of a sphere in
   velocity space. */
double laws_density(const struct law *law, double x)
{
    const double *p = law->parameter;
    const bool speed = law->kind == LAW_MAXWELL && p[2] > 0;
    assert(law->given == kinds[law->kind].most);
    if (law->kind == LAW_MICROCANONICAL || law->kind == LAW_BETA)
        return stretched_density(beta_of(law), x);
    if (law->kind == LAW_NORMAL)
        return gsl_ran_gaussian_pdf(x - p[0], p[1]);
    if (!speed)
        return gsl_ran_gaussian_pdf(x, sqrt(p[0] / p[1]));
    const double a = p[1] / (2 * p[0]); /* m / (2kT) */
    return x < 0 ? 0
                 : 2 * pow(a, p[2] / 2) * pow(x, p[2] - 1) *
                       exp(-a * x * x) / tgamma(p[2] / 2);
}

double laws_below(const struct law *law, double x)
{
    const double *p = law->parameter;
    const bool speed = law->kind == LAW_MAXWELL && p[2] > 0;
    assert(law->given == kinds[law->kind].most);
    if (law->kind == LAW_MICROCANONICAL || law->kind == LAW_BETA)
        return stretched_below(beta_of(law), x);
    if (law->kind == LAW_NORMAL)
        return gsl_cdf_gaussian_P(x - p[0], p[1]);
    if (!speed)
        return gsl_cdf_gaussian_P(x, sqrt(p[0] / p[1]));
    return x < 0 ? 0
                 : gsl_cdf_gamma_P(p[1] * x * x / (2 * p[0]), p[2] / 2, 1);
}

double laws_mean(const struct law *law)
{
    const double *p = law->parameter;
    switch (law->kind) {
    case LAW_NORMAL: return p[0];
    case LAW_BETA: return p[2] + (p[3] - p[2]) * p[0] / (p[1] + 1);
    case LAW_MAXWELL:
        if (p[2] > 0)
            return sqrt(2 * p[0] / p[1]) *
                   exp(lgamma((p[2] + 1) / 2) - lgamma(p[2] / 2));
        return 0;
    case LAW_MICROCANONICAL: return 0;
    }
    return 0;
}

double laws_sd(const struct law *law)
{
    const double *p = law->parameter;
    const double mean = laws_mean(law);
    switch (law->kind) {
    case LAW_NORMAL: return p[1];
    case LAW_BETA:
        return (p[3] - p[2]) / (p[1] + 1) *
               sqrt(p[0] * (p[1] + 1 - p[0]) / (p[1] + 2));
    case LAW_MAXWELL:
        return sqrt(fmax(p[2], 1) * p[0] / p[1] - mean * mean);
    case LAW_MICROCANONICAL: return sqrt(2 * p[1] / (p[0] * p[2]));
    }
    return 0;
}

double laws_chi2(double chi2, double degrees)
{
    return gsl_cdf_chisq_Q(chi2, degrees);
}

/* Uses one of two series. Both converge most slowly at lambda = 1, where
   the omitted terms are below 1e-40. */
double laws_kolmogorov(double lambda)
{
    const double pi = acos(-1);
    double sum = 0;
    if (lambda <= 0)
        return 1;
    if (lambda < 1) { /* this series converges better here */
        for (int k = 1; k < 8; k += 2)
            sum += exp(-k * k * pi * pi / (8 * lambda * lambda));
        return 1 - sqrt(2 * pi) / lambda * sum;
    }
    for (int k = 1; k < 8; ++k)
        sum += (k % 2 ? 2 : -2) * exp(-2 * k * k * lambda * lambda);
    return sum;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Returns the largest difference between the law and the empirical
   distribution function of the samples, which is a step function. below
   contains the cumulative probabilities of the law at the samples,
   sorted. */
static double largest_distance(size_t n, const double below[])
{
    double distance = 0;
    for (size_t i = 0; i < n; ++i) {
        const double foot = (double)i / (double)n;
        const double top = (double)(i + 1) / (double)n;
        distance = fmax(distance, fmax(below[i] - foot, top - below[i]));
    }
    return distance;
}

/* Returns the bin that contains a cumulative probability. For samples that
   obey the law, these probabilities are uniformly distributed from 0 to 1,
   so all bins are equally probable. */
static size_t bin_of(double below)
{
    return below < 1 ? (size_t)(below * LAW_CELLS) : LAW_CELLS - 1;
}

/* Estimates, from the counts in blocks, how much correlations change the
   distribution of chi-square. Returns false if memory runs out. */
static bool find_scatter(size_t n, const double below[], size_t block,
                         struct statistics_scatter *s)
{
    const size_t blocks = n / block;
    double *count = calloc(blocks * LAW_CELLS, sizeof count[0]);
    if (!count)
        return false;
    for (size_t i = 0; i < blocks * block; ++i)
        ++count[i / block * LAW_CELLS + bin_of(below[i])];
    *s = statistics_scatter(blocks, LAW_CELLS, count,
                            (double)block / LAW_CELLS);
    free(count);
    return true;
}

/* A law that was fitted to the samples is closer to them than (3.16,
   eq:kolmogorov) expects. The probability of its distance is then unknown,
   and is set to NaN. */
bool laws_test(const struct law *law, size_t n, const double x[], double g,
               size_t block, size_t fitted, struct law_test *t)
{
    const double independent = (double)n / g;
    struct statistics_scatter s = {1, LAW_CELLS - 1};
    double *below = malloc(n * sizeof below[0]); /* laws_below at each
                                                    sample */
    if (!below)
        return false;
    for (size_t i = 0; i < n; ++i)
        below[i] = laws_below(law, x[i]);
    if (block > 1 && n / block >= 3 && !find_scatter(n, below, block, &s)) {
        free(below);
        return false;
    }
    double count[LAW_CELLS] = {0};
    const double expected = (double)n / LAW_CELLS;
    for (size_t i = 0; i < n; ++i)
        ++count[bin_of(below[i])];
    t->chi2 = 0;
    for (size_t k = 0; k < LAW_CELLS; ++k)
        t->chi2 += (count[k] - expected) * (count[k] - expected) /
                   expected / s.scale;
    t->degrees =
        s.degrees * (double)(LAW_CELLS - 1 - fitted) / (LAW_CELLS - 1);
    t->chi2_probability = laws_chi2(t->chi2, t->degrees);
    qsort(below, n, sizeof below[0], by_size);
    t->distance = largest_distance(n, below);
    free(below);
    const double root = sqrt(independent);
    t->distance_probability =
        fitted ? NAN
               : laws_kolmogorov(t->distance * (root + 0.12 + 0.11 / root));
    return true;
}
