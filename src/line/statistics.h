/* Means, histograms and errors of a series of measurements. */
#ifndef STATISTICS_H
#define STATISTICS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A series is an array x of n finite numbers in the order of measurement.
   Every error is one standard deviation, in the unit of the number to which
   it belongs. */

/* The moments of a series, which do not depend on its order. */
struct statistics_moments {
    double mean, variance; /* the variance has the divisor n - 1 */
    double third, fourth;  /* means of (x - mean)^3 and ^4 */
    double least, greatest;
};

enum {
    STATISTICS_LEVELS = 48,       /* largest number of block lengths */
    STATISTICS_FEWEST_BLOCKS = 16 /* with fewer blocks, errors are
                                     unreliable */
};

/* The error of the mean, estimated from blocks of one length. */
struct statistics_block {
    size_t length, blocks;
    double error, uncertainty; /* uncertainty: the error of `error` */
};

/* The error of the mean, estimated from blocks of 1, 2, 4, ... samples. */
struct statistics_blocking {
    size_t levels, chosen; /* number of lengths; index of the chosen
                              length */
    bool plateau;          /* false: the error is only a lower bound */
    double error;          /* error of the mean, from the chosen level */
    double inefficiency;   /* samples per independent sample */
    struct statistics_block level[STATISTICS_LEVELS];
};

/* The inefficiency, estimated from the sum of the correlations over a
   window of lags. */
struct statistics_correlation {
    size_t window;
    bool settled; /* false: even the longest window was too short */
    double inefficiency, uncertainty;
    double error; /* error of the mean */
};

/* The counts of samples in equal bins. Bin i begins at low + i (high - low)
   / bins. */
struct statistics_histogram {
    double low, high;
    size_t bins;
    uint64_t total, below, above; /* all samples; samples below low; above
                                     high */
    uint64_t count[];             /* samples in each bin */
};

/* The Gaussian fitted to a histogram. */
struct statistics_gaussian {
    double mean, sd, mean_error, sd_error;
    double chi2;    /* chi-square of the fit, divided by the inefficiency */
    size_t degrees; /* degrees of freedom of chi2 */
};

/* The description of a series: mean, standard deviation and kurtosis with
   their errors. */
struct statistics_description {
    size_t n;
    double least, greatest;
    double mean, mean_error, sd, sd_error, kurtosis, kurtosis_error;
    double naive_error;  /* error of the mean if all samples were
                            independent */
    double inefficiency; /* statistical inefficiency: the larger of those of
                            x and of (x - mean)^2, but at least 1 */
    size_t block;        /* longest block used, in samples */
    bool plateau;        /* false: the errors are only lower bounds */
};

/* The distribution of chi-square for correlated counts: approximately that
   of `scale` times a chi-square variate with `degrees` degrees of
   freedom. */
struct statistics_scatter {
    double scale, degrees;
};

/* The dependence of two series on each other. */
struct statistics_dependence {
    double correlation, error; /* coefficient and its error */
    double chi2;               /* chi-square of a contingency table */
    size_t degrees;            /* degrees of freedom of chi2 */
};

/* Returns the moments of a series. Requires n >= 2. */
struct statistics_moments statistics_moments(size_t n, const double x[]);

/* Returns a power of two near the largest |x[i]|. In this unit powers of
   deviations neither overflow nor underflow. */
double statistics_unit(size_t n, const double x[]);

/* Estimates the error of the mean by blocking. Returns false if memory runs
   out. Requires n >= 2. Sources: Flyvbjerg and Petersen, J. Chem. Phys. 91,
   461 (1989); for the choice of the block length (3.11, eq:choice). */
bool statistics_blocking(size_t n, const double x[],
                         struct statistics_blocking *b);

/* Estimates the inefficiency from the sum of the correlations of a series
   (3.8, eq:inefficiency). The sum ends at a lag called the window: the
   first lag that is at least 6 and at least six correlation times (tau = g
   / 2), or else n / 8. The computing time is proportional to n times the
   window. Requires n >= 2. Sources: Sokal's lectures (1997); uncertainty
   and bias: Wolff, Comput. Phys. Commun. 156, 143 (2004). */
struct statistics_correlation statistics_correlation(size_t n,
                                                     const double x[]);

/* Returns the mean of (x[i] - mean) (x[i + lag] - mean), for lag < n. */
double statistics_covariance(size_t n, const double x[], double mean,
                             size_t lag);

/* Returns an empty histogram, or NULL if memory runs out. Free it with
   free(). Requires low < high with a finite difference and bins > 0. */
struct statistics_histogram *statistics_histogram_create(double low,
                                                         double high,
                                                         size_t bins);

/* Counts x in its bin. The last bin includes high. */
void statistics_histogram_add(struct statistics_histogram *h, double x);

/* Returns the lower edge of bin i or, for i = bins, the upper edge of the
   last bin. */
double statistics_histogram_edge(const struct statistics_histogram *h,
                                 size_t i);

/* Return the density of bin i (3.17, eq:density) and its error (3.18,
   eq:bar), where `inefficiency` samples count as one independent sample. */
double statistics_histogram_density(const struct statistics_histogram *h,
                                    size_t i);
double statistics_histogram_error(const struct statistics_histogram *h,
                                  size_t i, double inefficiency);

/* Returns a suitable number of bins from low to high for n samples of
   standard deviation sd (3.19, eq:width), from 1 to 1000. */
size_t statistics_bins(size_t n, double low, double high, double sd);

/* Fits a Gaussian by maximum likelihood (3.20, eq:score). g is the
   inefficiency of the samples, 1 if they are independent. Returns false if
   all samples are in a single bin, or if Newton's method does not
   converge. */
bool statistics_fit_gaussian(const struct statistics_histogram *h, double g,
                             struct statistics_gaussian *fit);

/* Returns the probability of the interval from a to b under a Gaussian. */
double statistics_gaussian_between(double mean, double sd, double a,
                                   double b);

/* Describes x. If `serial`, errors are estimated by blocking. Otherwise the
   samples are assumed to be independent. Returns false if memory runs out.
   Requires n >= 2. */
bool statistics_describe(size_t n, const double x[], bool serial,
                         struct statistics_description *d);

/* Measures the scatter of counts (3.15, eq:scatter) over blocks that are
   long enough to be independent. count[b * cells + k] is the number of
   samples of block b in cell k, on average `expected`. Requires at least 3
   blocks. Source: Satterthwaite, Biometrics Bull. 2, 110 (1946). */
struct statistics_scatter statistics_scatter(size_t blocks, size_t cells,
                                             const double count[],
                                             double expected);

/* Compares x with y, which are measured at the same times. Computes their
   correlation, with an error from blocking if `serial`, and chi-square of a
   contingency table of cells x cells entries, which have equal expected
   counts if x and y are independent. Chi-square is not divided by an
   inefficiency. Returns false if memory runs out, or if x or y is constant.
   Requires n >= 2, cells >= 2. */
bool statistics_dependence(size_t n, const double x[], const double y[],
                           size_t cells, bool serial,
                           struct statistics_dependence *d);

#endif
