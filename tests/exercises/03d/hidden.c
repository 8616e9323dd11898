/* What the grader also asks of exercise 03d: a series played backwards and
   in other units, and its block means taken for a series. */

#include "examiner/check.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

bool error_by_blocks(size_t n, const double x[], size_t length,
                     double *error, double *inefficiency);

enum { MOST = 3000 };

/* A series that remembers, and how it is cut; no value is left over. */
struct run {
    size_t blocks, length;
    double memory, x[MOST];
};

static void draw_run(struct run *r)
{
    double value = 0.0;
    r->blocks = (size_t)check_draw_whole(5, 60);
    r->length = (size_t)check_draw_whole(2, MOST / 60);
    r->memory = check_draw(0.1, 0.95);
    for (size_t i = 0; i < r->blocks * r->length; ++i) {
        value = r->memory * value + check_draw(-1.0, 1.0);
        r->x[i] = value;
    }
}

struct answer {
    double error, g;
};

/* NaN where nothing is told: all these series have five blocks and more. */
static struct answer answer(size_t n, const double x[], size_t length)
{
    struct answer a = {NAN, NAN};
    if (!error_by_blocks(n, x, length, &a.error, &a.g))
        a.error = a.g = NAN;
    return a;
}

static bool check_same(const char *quantity, const struct run *r,
                       double got, double expected)
{
    return CHECK_NEAR(
        got, .quantity = quantity,
        .input = check_text("%zu blocks of %zu values, each %g times the "
                            "one before plus something new",
                            r->blocks, r->length, r->memory),
        .expected = expected, .tolerance = 1e-11 * expected,
        .because = "1e-11 of it: the roundings of 3000 values",
        .equation = "eq:block",
        .question = "The same numbers, told in two ways, have two errors. "
                    "Does your answer depend on where the values lie, on "
                    "their unit, or on their order?");
}

static void test_backwards(void)
{
    static struct run r;
    static double back[MOST];
    for (int i = 0; i < 5; ++i) {
        draw_run(&r);
        const size_t n = r.blocks * r.length;
        const double unit = i % 2 ? -1e6 : 1e-6;
        for (size_t k = 0; k < n; ++k)
            back[n - 1 - k] = r.x[k] * unit;
        const struct answer a = answer(n, r.x, r.length);
        const struct answer b = answer(n, back, r.length);
        if (!(check_same(check_text("standard error of the series "
                                    "backwards and times %g",
                                    unit),
                         &r, b.error, fabs(unit) * a.error) &&
              check_same("inefficiency of the series backwards and in "
                         "other units",
                         &r, b.g, a.g)))
            return;
    }
}

static void test_means(void)
{
    static struct run r;
    double mean[MOST];
    for (int i = 0; i < 5; ++i) {
        draw_run(&r);
        for (size_t k = 0; k < r.blocks; ++k) {
            double sum = 0.0;
            for (size_t j = 0; j < r.length; ++j)
                sum += r.x[k * r.length + j];
            mean[k] = sum / (double)r.length;
        }
        const size_t n = r.blocks * r.length;
        const struct answer blocks = answer(n, r.x, r.length);
        const struct answer means = answer(r.blocks, mean, 1);
        const struct answer ones = answer(n, r.x, 1);
        const double ratio = blocks.error / ones.error;
        if (!(check_same("standard error of the block means, each taken "
                         "for a value",
                         &r, means.error, blocks.error) &&
              check_same("inefficiency of blocks of one value", &r, ones.g,
                         1.0) &&
              check_same("inefficiency", &r, blocks.g, ratio * ratio)))
            return;
    }
}

const struct check_test check_hidden[] = {
    {"backwards and in other units nothing is lost", test_backwards, 2, 0},
    {"block means are values like others", test_means, 2, 0},
    {0}};
