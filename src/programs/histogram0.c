/* From chapters/03-equilibrium.nw: edit there, then run make tangle. */
/* checksum 316444286 of the lines below */
/* Prints histograms of columns of numbers, with errors from blocking. */
#include "line/statistics.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { COLUMNS = 4, ROWS = 1 << 20, LONGEST = 4096 };
static double x[COLUMNS][ROWS], square[ROWS];

static double number(const char *row, long column)
{
    double found = 0;
    char *end = (char *)row;
    while (column-- > 0)
        found = strtod(end, &end);
    return found;
}

static double inefficiency(size_t n, const double series[], double mean)
{
    struct statistics_blocking one, two;
    for (size_t i = 0; i < n; ++i)
        square[i] = (series[i] - mean) * (series[i] - mean);
    if (!statistics_blocking(n, series, &one) ||
        !statistics_blocking(n, square, &two))
        exit(1); /* no memory */
    return fmax(1, fmax(one.inefficiency, two.inefficiency));
}

static void print(size_t n, const double series[], size_t bins,
                  char *told[])
{
    const double mean = statistics_moments(n, series).mean;
    const double g = inefficiency(n, series, mean);
    struct statistics_histogram *h =
        statistics_histogram_create(atof(told[1]), atof(told[2]), bins);
    for (size_t i = 0; h && i < n; ++i)
        statistics_histogram_add(h, series[i]);
    printf("# column %s: %zu samples, mean %.6g, inefficiency %.6g\n",
           told[0], n, mean, g);
    for (size_t i = 0; h && i < bins; ++i)
        printf("%.9g %.9g %.9g\n",
               statistics_histogram_edge(h, i) / 2 +
                   statistics_histogram_edge(h, i + 1) / 2,
               statistics_histogram_density(h, i),
               statistics_histogram_error(h, i, g));
    printf("\n\n");
    free(h);
}

/* Usage: histogram0 BINS, then COLUMN LOW HIGH for each histogram. */
int main(int argc, char *argv[])
{
    const int columns = (argc - 2) / 3;
    const size_t bins = argc > 4 ? strtoul(argv[1], NULL, 10) : 0;
    char row[LONGEST];
    size_t n = 0;
    if (bins < 1 || argc != 2 + 3 * columns || columns > COLUMNS) {
        fprintf(stderr, "histogram0: expected BINS COLUMN LOW HIGH ...\n");
        return 2;
    }
    while (n < ROWS && fgets(row, LONGEST, stdin)) {
        for (int c = 0; c < columns; ++c)
            x[c][n] = number(row, atol(argv[2 + 3 * c]));
        n += row[0] != '#';
    }
    for (int c = 0; c < columns && n > 1; ++c)
        print(n, x[c], bins, argv + 2 + 3 * c);
    return 0;
}
