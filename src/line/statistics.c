/* From chapters/03-equilibrium.nw: edit there, then run make tangle. */
/* checksum 3759088483 of the lines below */
/* Moments, bins, a fit, blocks and correlations of a series. */
#include "line/statistics.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>

double statistics_unit(size_t n, const double x[])
{
    double largest = 0;
    for (size_t i = 0; i < n; ++i)
        largest = fmax(largest, fabs(x[i]));
    if (largest == 0)
        return 1;
    /* Beyond these limits a unit or its inverse would be no number. */
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
    const double n = (double)h->total / inefficiency; /* independent */
    const double share = (double)h->count[i] / (double)h->total;
    const double p = fmin(fmax(share, 1 / n), 1 - 1 / n);
    return sqrt(p * (1 - p) / n) / width;
}

size_t statistics_bins(size_t n, double low, double high, double sd)
{
    const double width = 3.49 * sd / cbrt((double)n);
    const double bins = ceil((high - low) / width);
    return bins >= 1 && bins <= 1000 ? (size_t)bins : bins < 1 ? 1 : 1000;
}

double statistics_gaussian_between(double mean, double sd, double a,
                                   double b)
{
    const double from = (a - mean) / (sd * sqrt(2));
    const double to = (b - mean) / (sd * sqrt(2));
    if (from > 0)
        return 0.5 * (erfc(from) - erfc(to));
    return 0.5 * (erfc(-to) - erfc(-from));
}

/* (z^power) phi(z) / sd, with z = (x - mean) / sd. */
static double bell(double x, double mean, double sd, int power)
{
    const double z = (x - mean) / sd;
    if (isinf(z))
        return 0;
    return exp(-z * z / 2) / (sd * sqrt(8 * atan(1))) * (power ? z : 1);
}

struct newton {
    double score[2], information[3]; /* I: mean-mean, mean-sd, sd-sd */
};

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

/* An edge in this unit: the information goes with the inverse fourth power
   of the standard deviation, which beyond 1e77 would be zero. */
static double edge_in(double unit, const struct statistics_histogram *h,
                      size_t i)
{
    return statistics_histogram_edge(h, i) / unit;
}

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
    return *sd > 0; /* NaN where nothing is inside */
}

static void hold_against(const struct statistics_histogram *h, double unit,
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
            hold_against(h, unit, g, fit);
            fit->mean = mean * unit;
            fit->sd = sd * unit;
            fit->mean_error = sqrt(g * in[2] / determinant) * unit;
            fit->sd_error = sqrt(g * in[0] / determinant) * unit;
            return true;
        }
    }
    return false;
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
    b->plateau = naive == 0; /* a constant has no error to wait for */
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
        for (size_t i = 0; i < n; ++i) /* an odd one is left out */
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

/* statistics_covariance, all of it in this unit. */
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

/* Copies x to u in a unit of its size, which it returns. */
static double in_unit(size_t n, const double x[], double u[])
{
    const double unit = statistics_unit(n, x), inverse = 1 / unit;
    for (size_t i = 0; i < n; ++i)
        u[i] = x[i] * inverse;
    return unit;
}

enum number { MEAN, VARIANCE, KURTOSIS };

static void additions(size_t n, const double x[], double y[],
                      const struct statistics_moments *m, enum number of)
{
    const double v = m->variance, kurtosis = m->fourth / (v * v);
    const double skew = 4 * m->third / (v * v);
    for (size_t i = 0; i < n; ++i) {
        const double d = x[i] - m->mean, square = d * d;
        y[i] = of == MEAN       ? x[i]
               : of == VARIANCE ? square
                                : square * square / (v * v) -
                                      2 * kurtosis / v * square - skew * d;
    }
}

static bool error_of(size_t n, const double y[], bool serial,
                     struct statistics_description *d, double *error)
{
    struct statistics_blocking b;
    if (!serial) {
        *error = error_of_blocks(n, y, 1).error;
        return true;
    }
    if (!statistics_blocking(n, y, &b))
        return false;
    *error = b.error;
    d->inefficiency = fmax(d->inefficiency, b.inefficiency);
    d->plateau = d->plateau && b.plateau;
    if (b.level[b.chosen].length > d->block)
        d->block = b.level[b.chosen].length;
    return true;
}

bool statistics_describe(size_t n, const double x[], bool serial,
                         struct statistics_description *d)
{
    double *u = calloc(n, sizeof u[0]); /* x in a unit of its size */
    double *y = calloc(n, sizeof y[0]);
    bool done = u && y;
    if (done) {
        const double unit = in_unit(n, x, u);
        const struct statistics_moments m = statistics_moments(n, u);
        double *const own[] = {&d->least,      &d->greatest, &d->mean,
                               &d->mean_error, &d->sd,       &d->sd_error,
                               &d->naive_error};
        const double v = m.variance;
        *d = (struct statistics_description){
            .n = n, .least = m.least, .greatest = m.greatest};
        d->mean = m.mean;
        d->sd = sqrt(v);
        d->kurtosis = v > 0 ? m.fourth / (v * v) : 0;
        d->naive_error = d->sd / sqrt((double)n);
        d->inefficiency = 1;
        d->plateau = true;
        done = error_of(n, u, serial, d, &d->mean_error);
        if (m.variance > 0) {
            additions(n, u, y, &m, VARIANCE);
            done = done && error_of(n, y, serial, d, &d->sd_error);
            d->sd_error /= 2 * d->sd;
            const double inefficiency = d->inefficiency;
            additions(n, u, y, &m, KURTOSIS);
            done = done && error_of(n, y, serial, d, &d->kurtosis_error);
            d->inefficiency = inefficiency;
        }
        for (size_t k = 0; k < sizeof own / sizeof own[0]; ++k)
            *own[k] *= unit;
    }
    free(u);
    free(y);
    return done;
}

static double covariance(size_t blocks, size_t cells, const double a[],
                         const double b[])
{
    double of_a = 0, of_b = 0, sum = 0;
    for (size_t i = 0; i < blocks; ++i) {
        of_a += a[i * cells] / (double)blocks;
        of_b += b[i * cells] / (double)blocks;
    }
    for (size_t i = 0; i < blocks; ++i)
        sum += (a[i * cells] - of_a) * (b[i * cells] - of_b);
    return sum / (double)(blocks - 1);
}

struct statistics_scatter statistics_scatter(size_t blocks, size_t cells,
                                             const double count[],
                                             double expected)
{
    const double m = (double)blocks;
    double sum = 0, square = 0;
    for (size_t k = 0; k < cells; ++k)
        for (size_t l = 0; l < cells; ++l) {
            const double v =
                covariance(blocks, cells, count + k, count + l) / expected;
            sum += k == l ? v : 0;
            square += v * v;
        }
    if (!(sum > 0)) /* all blocks are alike */
        return (struct statistics_scatter){1, (double)(cells - 1)};
    square = (m - 1) * (m - 1) / ((m - 2) * (m + 1)) *
             (square - sum * sum / (m - 1));
    square = fmax(square, sum * sum / (double)(cells - 1));
    return (struct statistics_scatter){square / sum, sum * sum / square};
}
struct placed {
    double value;
    size_t place;
};

static int by_value(const void *a, const void *b)
{
    const struct placed *p = a, *q = b;
    return (p->value > q->value) - (p->value < q->value);
}

/* Sorts a copy of x and numbers the samples by the cell of their rank;
   returns the numbers, for free, or NULL. */
static size_t *cells_of(size_t n, const double x[], size_t cells)
{
    struct placed *sorted = malloc(n * sizeof sorted[0]);
    size_t *cell = malloc(n * sizeof cell[0]);
    for (size_t i = 0; sorted && cell && i < n; ++i)
        sorted[i] = (struct placed){x[i], i};
    if (sorted && cell)
        qsort(sorted, n, sizeof sorted[0], by_value);
    for (size_t i = 0; sorted && cell && i < n; ++i)
        cell[sorted[i].place] =
            (size_t)((double)i * (double)cells / (double)n);
    if (!sorted)
        free(cell);
    free(sorted);
    return sorted ? cell : NULL;
}

static bool count_table(size_t n, const double x[], const double y[],
                        size_t cells, struct statistics_dependence *d)
{
    size_t *row = cells_of(n, x, cells), *column = cells_of(n, y, cells);
    double *count = calloc(cells * cells, sizeof count[0]);
    const double expected = (double)n / (double)(cells * cells);
    const bool done = row && column && count;
    for (size_t i = 0; done && i < n; ++i)
        ++count[row[i] * cells + column[i]];
    d->chi2 = 0;
    for (size_t k = 0; done && k < cells * cells; ++k)
        d->chi2 += (count[k] - expected) * (count[k] - expected) / expected;
    d->degrees = (cells - 1) * (cells - 1);
    free(row);
    free(column);
    free(count);
    return done;
}

bool statistics_dependence(size_t n, const double x[], const double y[],
                           size_t cells, bool serial,
                           struct statistics_dependence *d)
{
    struct statistics_description unused = {0};
    double *u = calloc(n, sizeof u[0]), *v = calloc(n, sizeof v[0]);
    bool done = u && v;
    d->correlation = d->error = 0;
    if (done) {
        in_unit(n, x, u);
        in_unit(n, y, v);
        const struct statistics_moments a = statistics_moments(n, u);
        const struct statistics_moments b = statistics_moments(n, v);
        const double scale = sqrt(a.variance * b.variance);
        for (size_t i = 0; scale > 0 && i < n; ++i) {
            u[i] = (u[i] - a.mean) * (v[i] - b.mean) / scale;
            d->correlation += u[i] / (double)n;
        }
        done = scale > 0 && error_of(n, u, serial, &unused, &d->error);
    }
    free(u);
    free(v);
    return done && count_table(n, x, y, cells, d);
}
