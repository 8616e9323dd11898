/* From chapters/03-equilibrium.nw: edit there, then run make tangle. */
/* checksum 1845504987 of the lines below */
/* Computes moments, errors, correlations and histograms of a series. */
#include "line/statistics.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

double statistics_unit(size_t n, const double x[])
{
    double largest = 0;
    for (size_t i = 0; i < n; ++i)
        largest = fmax(largest, fabs(x[i]));
    if (largest == 0)
        return 1;
    /* Beyond these limits a unit or its inverse would overflow. */
    return ldexp(1, (int)fmax(fmin(ilogb(largest), 1022), -1022));
}

static double mean_in(double unit, size_t n, const double x[])
{
    const double inverse = 1 / unit;
    double sum = 0;
    for (size_t i = 0; i < n; ++i)
        sum += x[i] * inverse;
    return sum / (double)n;
}

struct statistics_moments statistics_moments(size_t n, const double x[])
{
    struct statistics_moments m = {.least = x[0], .greatest = x[0]};
    const double unit = statistics_unit(n, x), inverse = 1 / unit;
    const double mean = mean_in(unit, n, x);
    double first = 0, square = 0, cube = 0, fourth = 0;
    assert(n >= 2);
    for (size_t i = 0; i < n; ++i) {
        const double d = x[i] * inverse - mean;
        first += d;
        square += d * d;
        cube += d * d * d;
        fourth += d * d * d * d;
        m.least = fmin(m.least, x[i]);
        m.greatest = fmax(m.greatest, x[i]);
    }
    const double rest = first * first / (double)n;
    m.mean = mean * unit;
    m.variance = fmax(square - rest, 0) / (double)(n - 1) * unit * unit;
    m.third = cube / (double)n * unit * unit * unit;
    m.fourth = fourth / (double)n * unit * unit * unit * unit;
    return m;
}

static struct statistics_block error_of_blocks(size_t n, const double x[],
                                               size_t length)
{
    const struct statistics_moments m = statistics_moments(n, x);
    struct statistics_block b = {.length = length, .blocks = n};
    b.error = sqrt(m.variance / (double)n);
    b.uncertainty = b.error / sqrt(2 * (double)(n - 1));
    return b;
}

static void choose_level(struct statistics_blocking *b)
{
    const double naive = b->level[0].error;
    const double n = (double)b->level[0].blocks;
    b->chosen = 0;
    b->plateau = naive == 0; /* a constant needs no plateau */
    b->inefficiency = 1;
    for (size_t k = 0; k < b->levels && naive > 0; ++k) {
        const struct statistics_block *l = &b->level[k];
        const double g = l->error * l->error / (naive * naive);
        if (l->blocks < STATISTICS_FEWEST_BLOCKS)
            break;
        const double length = (double)l->length;
        const double least = b->level[b->chosen].error;
        const bool rule = length * length * length >= 2 * n * g * g;
        const bool sure = l->blocks >= 4 * STATISTICS_FEWEST_BLOCKS;
        if (b->plateau ? sure && l->error - l->uncertainty > least
                       : rule || l->error > least) {
            b->chosen = k;
            b->inefficiency = g;
        }
        b->plateau = b->plateau || rule; /* (3.11, eq:choice) */
    }
    b->error = b->level[b->chosen].error;
}

bool statistics_blocking(size_t n, const double x[],
                         struct statistics_blocking *b)
{
    double *block = malloc(n * sizeof block[0]);
    const double unit = statistics_unit(n, x), inverse = 1 / unit;
    size_t length = 1;
    if (!block)
        return false;
    for (size_t i = 0; i < n; ++i)
        block[i] = x[i] * inverse;
    for (b->levels = 0; n >= 2 && b->levels < STATISTICS_LEVELS;) {
        b->level[b->levels++] = error_of_blocks(n, block, length);
        n /= 2;
        length *= 2;
        for (size_t i = 0; i < n; ++i) /* an odd block is dropped */
            block[i] = (block[2 * i] + block[2 * i + 1]) / 2;
    }
    free(block);
    choose_level(b);
    for (size_t k = 0; k < b->levels; ++k) {
        b->level[k].error *= unit;
        b->level[k].uncertainty *= unit;
    }
    b->error *= unit;
    return true;
}

/* Returns the covariance as statistics_covariance does, but in units of
   unit^2. The mean is in units of `unit`. */
static double covariance_in(double unit, size_t n, const double x[],
                            double mean, size_t lag)
{
    const double inverse = 1 / unit;
    double sum = 0;
    assert(lag < n);
    for (size_t i = 0; i + lag < n; ++i)
        sum += (x[i] * inverse - mean) * (x[i + lag] * inverse - mean);
    return sum / (double)(n - lag);
}

double statistics_covariance(size_t n, const double x[], double mean,
                             size_t lag)
{
    const double unit = statistics_unit(n, x);
    return covariance_in(unit, n, x, mean / unit, lag) * unit * unit;
}

struct statistics_correlation statistics_correlation(size_t n,
                                                     const double x[])
{
    struct statistics_correlation c = {.inefficiency = 1};
    const double unit = statistics_unit(n, x), mean = mean_in(unit, n, x);
    const double variance = covariance_in(unit, n, x, mean, 0);
    double g = 1;
    while (variance > 0 && !c.settled && c.window < n / 8) {
        ++c.window;
        g += 2 * covariance_in(unit, n, x, mean, c.window) / variance;
        c.settled = (double)c.window >= fmax(3 * g, 6);
    }
    c.settled = c.settled || variance == 0;
    const double lags = 2 * (double)c.window + 1;
    c.inefficiency = fmax(g * (1 + lags / (double)n), 0);
    c.uncertainty = c.inefficiency * sqrt(2 * lags / (double)n);
    c.error = sqrt(variance * c.inefficiency / (double)n) * unit;
    return c;
}

struct statistics_histogram *statistics_histogram_create(double low,
                                                         double high,
                                                         size_t bins)
{
    struct statistics_histogram *h;
    assert(low < high && isfinite(high - low) && bins > 0);
    h = calloc(1, sizeof *h + bins * sizeof h->count[0]);
    if (h) {
        h->low = low;
        h->high = high;
        h->bins = bins;
    }
    return h;
}

void statistics_histogram_add(struct statistics_histogram *h, double x)
{
    const double place =
        (x - h->low) / (h->high - h->low) * (double)h->bins;
    ++h->total;
    if (x < h->low)
        ++h->below;
    else if (x > h->high)
        ++h->above;
    else
        ++h->count[place < (double)h->bins ? (size_t)place : h->bins - 1];
}

double statistics_histogram_edge(const struct statistics_histogram *h,
                                 size_t i)
{
    return h->low + (h->high - h->low) * ((double)i / (double)h->bins);
}

double statistics_histogram_density(const struct statistics_histogram *h,
                                    size_t i)
{
    const double width = (h->high - h->low) / (double)h->bins;
    const double unit = statistics_unit(1, &width);
    return (double)h->count[i] / ((double)h->total * (width / unit)) / unit;
}

double statistics_histogram_error(const struct statistics_histogram *h,
                                  size_t i, double inefficiency)
{
    const double width = (h->high - h->low) / (double)h->bins;
    const double n = (double)h->total / inefficiency;
    const double found = (double)h->count[i] / (double)h->total;
    const double p = fmin(fmax(found, 1 / n), 1 - 1 / n);
    return sqrt(p * (1 - p) / n) / width;
}

size_t statistics_bins(size_t n, double low, double high, double sd)
{
    const double width = 3.49 * sd / cbrt((double)n);
    const double bins = ceil((high - low) / width);
    return bins >= 1 && bins <= 1000 ? (size_t)bins : bins < 1 ? 1 : 1000;
}
