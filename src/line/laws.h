/* Laws of equilibrium statistics: densities, probabilities and tests. */
#ifndef LAWS_H
#define LAWS_H

#include <stdbool.h>
#include <stddef.h>

enum law_kind { LAW_NORMAL, LAW_MICROCANONICAL, LAW_BETA, LAW_MAXWELL };

enum { LAW_PARAMETERS = 4 };

/* A law and its parameters, in the order in which laws_read reads them. */
struct law {
    enum law_kind kind;
    size_t given; /* number of parameters that are set */
    double parameter[LAW_PARAMETERS];
};

enum { LAW_CELLS = 20 }; /* number of equally probable bins */

/* How well samples agree with a law. Each probability is that of an
   agreement at least this bad, if the samples obey the law. */
struct law_test {
    double distance;               /* Kolmogorov's distance */
    double distance_probability;   /* NaN if the law was fitted */
    double chi2, chi2_probability; /* from LAW_CELLS bins */
    double degrees;                /* degrees of freedom of chi2 */
};

/* Reads a law from text. Parts in brackets are optional:
     normal[:mean,sd]
     microcanonical:n[,E,m]   a velocity component of a body of mass m, if n
                              such components share the energy E
     beta:k,n[,low,high]      the k-th of n points between low and high
     maxwell:kT[,m[,d]]       a velocity component of a body of mass m at
                              temperature kT or, if d is given, its speed
                              in d dimensions
   Returns NULL, or an error message. */
const char *laws_read(const char *text, struct law *law);

/* Sets the parameters that were not given. The defaults are low = 0, high =
   1, m = 1, and d = 0 for a component. The other parameters are computed
   from `mean` and `sd`, those of a column of samples. Returns the number of
   computed parameters. */
size_t laws_complete(struct law *law, double mean, double sd);

/* Return the density of a complete law at x, in the inverse unit of x, and
   the probability of a value below x (3.2, eq:velocity-law), (3.5,
   eq:velocity-cdf), (3.7, eq:beta). */
double laws_density(const struct law *law, double x);
double laws_below(const struct law *law, double x);

/* Return the mean and the standard deviation of a complete law. */
double laws_mean(const struct law *law);
double laws_sd(const struct law *law);

/* Tests n samples against a complete law. g samples count as one
   independent sample, and `fitted` parameters of the law were computed from
   the samples. If there are at least 3 blocks of `block` > 1 samples, the
   scatter of chi-square is measured from these blocks, which are assumed to
   be independent. For a fitted law this overestimates the scatter. With
   fewer blocks, the scatter is that of independent samples. Returns false
   if memory runs out. Requires n >= 2, g > 0, fitted < LAW_CELLS - 1.
   Sources: Kolmogorov's limit with Stephens' correction, J. R. Statist.
   Soc. B 32, 115 (1970); Pearson's chi-square. */
bool laws_test(const struct law *law, size_t n, const double x[], double g,
               size_t block, size_t fitted, struct law_test *t);

/* Returns the probability that Kolmogorov's distance, multiplied by the
   square root of a large number of samples, exceeds lambda. */
double laws_kolmogorov(double lambda);

/* Returns the probability that chi-square with this number of degrees of
   freedom exceeds chi2. */
double laws_chi2(double chi2, double degrees);

#endif
