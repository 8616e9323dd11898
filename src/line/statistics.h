/* Means, histograms and honest errors of a series of measurements. */
#ifndef STATISTICS_H
#define STATISTICS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A series is an array x of n finite numbers in the order of measurement.
   Every error is one standard deviation, in the unit of its number. */

/* What can be said of a series without asking in which order it came. */
struct statistics_moments {
    double mean, variance; /* the variance with n - 1 below the line */
    double third, fourth;  /* mean powers of x - mean */
    double least, greatest;
};

enum {
    STATISTICS_LEVELS = 48,       /* the most lengths of blocks */
    STATISTICS_FEWEST_BLOCKS = 16 /* fewer say nothing about an error */
};

/* The error of the mean, as it looks from blocks of one length. */
struct statistics_block {
    size_t length, blocks;
    double error, uncertainty; /* and the error of that error */
};

/* The error of the mean from blocks of 1, 2, 4, ... samples. */
struct statistics_blocking {
    size_t levels, chosen; /* how many lengths, and which one to take */
    bool plateau;          /* false: the error is only a lower bound */
    double error;          /* of the mean: that of the chosen level */
    double inefficiency;   /* samples to one independent one */
    struct statistics_block level[STATISTICS_LEVELS];
};

/* The inefficiency from the sum of the correlations up to a window. */
struct statistics_correlation {
    size_t window;
    bool settled; /* false: no window was long enough */
    double inefficiency, uncertainty;
    double error; /* of the mean */
};

/* Counts in equal bins: bin i begins at low + i (high - low) / bins. */
struct statistics_histogram {
    double low, high;
    size_t bins;
    uint64_t total, below, above; /* all samples; those outside */
    uint64_t count[];             /* one for each bin */
};

/* The Gaussian that fits a histogram best. */
struct statistics_gaussian {
    double mean, sd, mean_error, sd_error;
    double chi2;    /* of the bins about the fit, divided by g */
    size_t degrees; /* of freedom that chi2 has */
};

/* What one column is worth saying: three numbers with their errors. */
struct statistics_description {
    size_t n;
    double least, greatest;
    double mean, mean_error, sd, sd_error, kurtosis, kurtosis_error;
    double naive_error;  /* of the mean, as if independent */
    double inefficiency; /* the largest of 1, of x, and of (x - mean)^2 */
    size_t block;        /* the longest of the blocks that were used */
    bool plateau;        /* false: the errors are only lower bounds */
};

/* The distribution of chi-square for correlated counts: it is about that of
   `scale` times a chi-square with this number of degrees of freedom. */
struct statistics_scatter {
    double scale, degrees;
};

/* Whether two series depend on each other. */
struct statistics_dependence {
    double correlation, error; /* the coefficient, and its error */
    double chi2;               /* of a table of equally filled cells, */
    size_t degrees;            /* and its degrees of freedom */
};

/* Returns the moments of a series. Requires n >= 2. */
struct statistics_moments statistics_moments(size_t n, const double x[]);

/* Returns a power of two near the largest |x[i]|. In it as a unit, powers
   of deviations neither overflow nor vanish. */
double statistics_unit(size_t n, const double x[]);

/* Blocks a series. Returns false if memory runs out. Requires n >= 2.
   Source: Flyvbjerg and Petersen, J. Chem. Phys. 91, 461 (1989); the choice
   of the length (3.11, eq:choice). */
bool statistics_blocking(size_t n, const double x[],
                         struct statistics_blocking *b);

/* Sums the correlations of a series (3.8, eq:inefficiency) up to the first
   lag that is six times the correlation time, tau = g / 2, at least to 6
   and at most to n / 8. Takes n times the window. Requires n >= 2.
   Sources: Sokal's lectures (1997); uncertainty and bias: Wolff, Comput.
   Phys. Commun. 156, 143 (2004). */
struct statistics_correlation statistics_correlation(size_t n,
                                                     const double x[]);

/* Returns the mean of (x[i] - mean) (x[i + lag] - mean). Requires lag < n.
 */
double statistics_covariance(size_t n, const double x[], double mean,
                             size_t lag);

/* Returns an empty histogram for free, or NULL if memory runs out. Requires
   low < high with a finite difference and bins > 0. */
struct statistics_histogram *statistics_histogram_create(double low,
                                                         double high,
                                                         size_t bins);

/* Counts x; in the last bin if it is exactly high. */
void statistics_histogram_add(struct statistics_histogram *h, double x);

/* Returns where bin i begins; i = bins gives the end of the last one. */
double statistics_histogram_edge(const struct statistics_histogram *h,
                                 size_t i);

/* Return the density of bin i (3.17, eq:density) and its error (3.18,
   eq:bar) when it takes `inefficiency` samples to make one independent one.
 */
double statistics_histogram_density(const struct statistics_histogram *h,
                                    size_t i);
double statistics_histogram_error(const struct statistics_histogram *h,
                                  size_t i, double inefficiency);

/* Returns how many bins from low to high suit n samples of standard
   deviation sd (3.19, eq:width), from 1 to 1000. */
size_t statistics_bins(size_t n, double low, double high, double sd);

/* Fits a Gaussian by maximum likelihood (3.20, eq:score); g is the
   inefficiency of the samples, 1 if they are independent. Returns false if
   there is no such Gaussian: all samples are in one bin, or the steps do
   not settle. */
bool statistics_fit_gaussian(const struct statistics_histogram *h, double g,
                             struct statistics_gaussian *fit);

/* Returns the probability that a Gaussian gives to the interval from a to
 * b. */
double statistics_gaussian_between(double mean, double sd, double a,
                                   double b);

/* Describes x. If serial, the errors come from blocking; otherwise the
   samples are taken for independent. Returns false if memory runs out.
   Requires n >= 2. */
bool statistics_describe(size_t n, const double x[], bool serial,
                         struct statistics_description *d);

/* Measures the scatter of counts (3.15, eq:scatter) over blocks that are
   long enough to be independent: count[b * cells + k] samples of block b
   are in cell k, where `expected` should be. Requires 3 blocks.
   Source: Satterthwaite, Biometrics Bull. 2, 110 (1946). */
struct statistics_scatter statistics_scatter(size_t blocks, size_t cells,
                                             const double count[],
                                             double expected);

/* Compares x with y, measured at the same times: their correlation, with an
   error from blocking if serial, and chi-square of a table of cells x cells
   that are equally full if they are independent, not yet divided by an
   inefficiency. Returns false if memory runs out, or if one of the two
   never changes. Requires n >= 2, cells >= 2. */
bool statistics_dependence(size_t n, const double x[], const double y[],
                           size_t cells, bool serial,
                           struct statistics_dependence *d);

#endif
