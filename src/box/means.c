/* Computes means over a run and their errors from blocks of samples. */
#include "box/means.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool means_create(struct means *m, size_t quantities)
{
    *m = (struct means){.quantities = quantities, .length = 1};
    m->sum = calloc(MEANS_BLOCKS * quantities, sizeof *m->sum);
    return m->sum != NULL;
}

void means_free(struct means *m)
{
    free(m->sum);
    m->sum = NULL;
}

void means_add(struct means *m, size_t quantity, double value)
{
    m->sum[m->blocks * m->quantities + quantity] += value;
}

/* Joins the blocks in pairs, and empties the second half of the blocks. */
static void join_blocks(struct means *m)
{
    const size_t n = m->quantities;
    m->blocks /= 2;
    m->length *= 2;
    for (size_t b = 0; b < m->blocks; ++b)
        for (size_t q = 0; q < n; ++q)
            m->sum[b * n + q] =
                m->sum[2 * b * n + q] + m->sum[(2 * b + 1) * n + q];
    memset(m->sum + m->blocks * n, 0, m->blocks * n * sizeof *m->sum);
}

void means_next(struct means *m)
{
    if (++m->filled < m->length)
        return;
    m->filled = 0;
    if (++m->blocks == MEANS_BLOCKS)
        join_blocks(m);
}

/* The mean includes the samples of the unfinished block. */
double means_mean(const struct means *m, size_t quantity)
{
    const double samples = (double)(m->blocks * m->length + m->filled);
    double sum = 0;
    for (size_t b = 0; b < m->blocks + (m->filled > 0); ++b)
        sum += m->sum[b * m->quantities + quantity];
    return samples > 0 ? sum / samples : NAN;
}

/* The full blocks are treated as independent values. */
double means_error(const struct means *m, size_t quantity)
{
    double mean = 0, squares = 0;
    for (size_t b = 0; b < m->blocks; ++b) {
        const double value =
            m->sum[b * m->quantities + quantity] / (double)m->length;
        const double deviation = value - mean;
        mean += deviation / (double)(b + 1);
        squares += deviation * (value - mean);
    }
    const double n = (double)m->blocks;
    return n > 1 ? sqrt(squares / (n - 1) / n) : NAN;
}
