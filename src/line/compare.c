/* Describes a series, measures scatter of counts, compares two series. */
#include "line/statistics.h"

#include <math.h>
#include <stdlib.h>

/* Fills u with the numbers x divided by statistics_unit(n, x), and returns
   this unit. */
static double in_unit(size_t n, const double x[], double u[])
{
    const double unit = statistics_unit(n, x), inverse = 1 / unit;
    for (size_t i = 0; i < n; ++i)
        u[i] = x[i] * inverse;
    return unit;
}

enum number { MEAN, VARIANCE, KURTOSIS };

/* Fills y with a series whose mean has the same standard error as the
   moment of x that `of` selects (3.12, eq:delta). */
static void series_of(size_t n, const double x[], double y[],
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

/* Sets *error to the standard error of the mean of y. If y is a time
   series (`serial`), the error is estimated from blocks. The inefficiency,
   block and plateau of *d keep the worst values of all calls. Returns false
   if memory runs out. */
static bool error_of(size_t n, const double y[], bool serial,
                     struct statistics_description *d, double *error)
{
    struct statistics_blocking b;
    if (!serial) {
        *error = sqrt(statistics_moments(n, y).variance / (double)n);
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

/* A constant series, such as the position of a wall, has no kurtosis. Its
   kurtosis and all errors are set to 0. */
bool statistics_describe(size_t n, const double x[], bool serial,
                         struct statistics_description *d)
{
    double *u = calloc(n, sizeof u[0]); /* x in units of statistics_unit */
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
            series_of(n, u, y, &m, VARIANCE);
            done = done && error_of(n, y, serial, d, &d->sd_error);
            d->sd_error /= 2 * d->sd;
            const double inefficiency = d->inefficiency;
            series_of(n, u, y, &m, KURTOSIS);
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

/* Returns the covariance of the counts of two cells over all blocks. */
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

/* The two sums over g in (3.15, eq:scatter) are the traces of two matrices:
   the covariance matrix of the counts, and its square. On average, the
   square of a measured covariance matrix is too large. For normally
   distributed counts the excess is known, and is subtracted here. */
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
    if (!(sum > 0)) /* all blocks are equal */
        return (struct statistics_scatter){1, (double)(cells - 1)};
    square = (m - 1) * (m - 1) / ((m - 2) * (m + 1)) *
             (square - sum * sum / (m - 1));
    square = fmax(square, sum * sum / (double)(cells - 1));
    return (struct statistics_scatter){square / sum, sum * sum / square};
}
/* A value of a series and its index in the series, for sorting by value. */
struct placed {
    double value;
    size_t place;
};

static int by_value(const void *a, const void *b)
{
    const struct placed *p = a, *q = b;
    return (p->value > q->value) - (p->value < q->value);
}

/* Divides the samples by rank into cells of equal size. Returns an array
   with the cell of each sample, or NULL if memory runs out. The caller
   frees the array. */
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

/* Computes chi-square and its degrees of freedom from a contingency table
   with `cells` rows and columns. If the two series are independent, all
   entries of the table have the same expected count. Returns false if
   memory runs out. */
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

/* The correlation coefficient is the mean of a product of two deviations,
   so its error is estimated like that of any mean. */
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
