/* Fits a Gaussian to the bins of a histogram by maximum likelihood. */
#include "line/statistics.h"

#include <float.h>
#include <math.h>

/* The probability of an interval is a difference of two values of the error
   function. Far to the right of the mean both values are almost 1, and
   their difference is lost in rounding. There erfc is used, whose values
   are small and accurate. */
double statistics_gaussian_between(double mean, double sd, double a,
                                   double b)
{
    const double from = (a - mean) / (sd * sqrt(2));
    const double to = (b - mean) / (sd * sqrt(2));
    if (from >= 0)
        return 0.5 * (erfc(from) - erfc(to));
    return 0.5 * (erfc(-to) - erfc(-from));
}

/* Returns z^power phi(z) / sd, where z = (x - mean) / sd and phi is the
   normal density. The derivative of the probability of a bin with respect
   to the mean (power 0) or sd (power 1) is the difference of this value
   between the two ends of the bin. At infinity z phi is zero, but floating
   point would give NaN. */
static double bell(double x, double mean, double sd, int power)
{
    const double z = (x - mean) / sd;
    if (isinf(z))
        return 0;
    return exp(-z * z / 2) / (sd * sqrt(8 * atan(1))) * (power ? z : 1);
}

/* The sums over the bins in (3.20, eq:score) and (3.21, eq:fisher). */
struct newton {
    double score[2], information[3]; /* information: mean-mean, mean-sd,
                                        sd-sd */
};

/* Adds a bin, which may be infinitely wide, to the sums. The probability is
   a divisor, so it is not allowed to underflow. */
static void add_bin(struct newton *s, double mean, double sd, double a,
                    double b, double count, double total)
{
    const double p =
        fmax(statistics_gaussian_between(mean, sd, a, b), DBL_MIN);
    const double slope[2] = {bell(a, mean, sd, 0) - bell(b, mean, sd, 0),
                             bell(a, mean, sd, 1) - bell(b, mean, sd, 1)};
    for (int k = 0; k < 2; ++k)
        s->score[k] += count / p * slope[k];
    s->information[0] += total * slope[0] * slope[0] / p;
    s->information[1] += total * slope[0] * slope[1] / p;
    s->information[2] += total * slope[1] * slope[1] / p;
}

/* Returns the lower edge of bin i divided by `unit`. The determinant of the
   information is proportional to the inverse fourth power of the standard
   deviation. Without this division it would underflow for standard
   deviations above 1e77. */
static double edge_in(double unit, const struct statistics_histogram *h,
                      size_t i)
{
    return statistics_histogram_edge(h, i) / unit;
}

/* Returns the sums over all bins, including the two infinitely wide bins
   outside the range. */
static struct newton newton_sums(const struct statistics_histogram *h,
                                 double unit, double mean, double sd)
{
    struct newton s = {{0, 0}, {0, 0, 0}};
    const double n = (double)h->total;
    add_bin(&s, mean, sd, -INFINITY, h->low / unit, (double)h->below, n);
    for (size_t i = 0; i < h->bins; ++i)
        add_bin(&s, mean, sd, edge_in(unit, h, i), edge_in(unit, h, i + 1),
                (double)h->count[i], n);
    add_bin(&s, mean, sd, h->high / unit, INFINITY, (double)h->above, n);
    return s;
}

/* Computes the start of Newton's method: the mean and standard deviation as
   if every sample were at the centre of its bin. They are computed relative
   to the lower end of the range, since digits would be lost if the range is
   far from zero. Returns false if the samples have no spread. */
static bool moments_of_bins(const struct statistics_histogram *h,
                            double unit, double *mean, double *sd)
{
    const double half = (h->high - h->low) / (double)h->bins / 2;
    double inside = 0, sum = 0, square = 0;
    for (size_t i = 0; i < h->bins; ++i) {
        const double x =
            (statistics_histogram_edge(h, i) + half - h->low) / unit;
        inside += (double)h->count[i];
        sum += (double)h->count[i] * x;
        square += (double)h->count[i] * x * x;
    }
    *mean = h->low / unit + sum / inside;
    *sd = sqrt(square / inside - sum / inside * (sum / inside));
    return *sd > 0; /* also false for NaN, if all samples are outside */
}

/* Computes chi-square of the counts about the fit, and its degrees of
   freedom. Neighbouring bins form groups. A group is complete when its
   expected count and that of the remaining bins are both at least five. The
   degrees of freedom are the number of groups minus three: one for the
   total, two for the fitted parameters. */
static void compare_with(const struct statistics_histogram *h, double unit,
                         double g, struct statistics_gaussian *fit)
{
    const double n = (double)h->total;
    double from = -INFINITY, found = (double)h->below;
    size_t groups = 0;
    fit->chi2 = 0;
    for (size_t i = 0; i <= h->bins + 1; ++i) {
        const bool last = i > h->bins;
        const double to = last ? INFINITY : edge_in(unit, h, i);
        const double expected =
            n * statistics_gaussian_between(fit->mean, fit->sd, from, to);
        const double rest = n * statistics_gaussian_between(
                                    fit->mean, fit->sd, to, INFINITY);
        if (last || (expected >= 5 && rest >= 5)) {
            fit->chi2 +=
                (found - expected) * (found - expected) / expected / g;
            ++groups;
            from = to;
            found = 0;
        }
        if (!last)
            found += (double)(i < h->bins ? h->count[i] : h->above);
    }
    fit->degrees = groups > 3 ? groups - 3 : 0;
}

/* Each Newton step is the inverse of the information matrix times the
   score, computed by Cramer's rule. A step that is too large is shortened,
   since the standard deviation must stay positive. A hundred steps are
   always enough. The diagonal of the inverse contains the variances of the
   two parameters. */
bool statistics_fit_gaussian(const struct statistics_histogram *h, double g,
                             struct statistics_gaussian *fit)
{
    const double unit =
        statistics_unit(2, (const double[]){h->low, h->high});
    double mean, sd;
    if (!moments_of_bins(h, unit, &mean, &sd))
        return false;
    for (int step = 0; step < 100; ++step) {
        const struct newton s = newton_sums(h, unit, mean, sd);
        const double *in = s.information;
        const double determinant = in[0] * in[2] - in[1] * in[1];
        if (!(determinant > 0))
            return false;
        const double to_mean =
            (in[2] * s.score[0] - in[1] * s.score[1]) / determinant;
        const double to_sd =
            (in[0] * s.score[1] - in[1] * s.score[0]) / determinant;
        mean += fmax(fmin(to_mean, sd), -sd);
        sd += fmax(fmin(to_sd, sd), -sd / 2);
        if (hypot(to_mean, to_sd) < 1e-9 * sd) {
            *fit = (struct statistics_gaussian){mean, sd, 0, 0, 0, 0};
            compare_with(h, unit, g, fit);
            fit->mean = mean * unit;
            fit->sd = sd * unit;
            fit->mean_error = sqrt(g * in[2] / determinant) * unit;
            fit->sd_error = sqrt(g * in[0] / determinant) * unit;
            return true;
        }
    }
    return false;
}
