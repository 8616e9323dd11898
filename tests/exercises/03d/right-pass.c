/* A right answer: one pass over the series, Welford's update for either
   variance. */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

struct spread {
    double count, mean, squares;
};

static void put(struct spread *s, double value)
{
    double step = value - s->mean;
    s->count += 1;
    s->mean += step / s->count;
    s->squares += step * (value - s->mean);
}

static double error_squared(const struct spread *s)
{
    return s->squares / (s->count - 1) / s->count;
}

bool error_by_blocks(size_t n, const double x[], size_t length,
                     double *error, double *inefficiency)
{
    struct spread values = {0, 0, 0}, blocks = {0, 0, 0};
    double block = 0;
    size_t i, inside = 0;
    if (length == 0)
        return false;
    n -= n % length;
    for (i = 0; i < n; i++) {
        put(&values, x[i]);
        block += x[i] - x[0];
        if (++inside == length) {
            put(&blocks, block / (double)length);
            block = 0;
            inside = 0;
        }
    }
    if (blocks.count < 2)
        return false;
    *error = sqrt(error_squared(&blocks));
    *inefficiency = *error / error_squared(&values) * *error;
    return true;
}
