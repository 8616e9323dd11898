/* Sums in blocks: nothing is lost when they are joined, and the error is
   that of the whole series. */
#include "unit.h"

#include "box/blocks.h"
#include "line/statistics.h"
#include "toolbox/random.h"

#include <stdlib.h>

/* Samples 0, 1, 2, ... : every full block is known. */
static void test_joined(void)
{
    struct blocks b;
    UNIT_TRUE(blocks_create(&b, 2));
    for (size_t n = 0; n < 5000; ++n)
        blocks_add(&b, (double[]){(double)n, 1});
    UNIT_EQUAL((double)b.per, 16); /* 256 to 511 blocks */
    UNIT_EQUAL((double)b.count, 5000 / 16);
    UNIT_EQUAL((double)b.filled, 5000 % 16);
    for (size_t i = 0; i < b.count; ++i) {
        UNIT_EQUAL(b.sum[2 * i], 16 * 16 * (double)i + 120);
        UNIT_EQUAL(b.sum[2 * i + 1], 16);
    }
    UNIT_EQUAL(blocks_average(&b, 1).mean, 1);
    UNIT_EQUAL(blocks_average(&b, 1).error, 0);
    UNIT_EQUAL(blocks_average(&b, 0).mean, (5000 / 16 * 16 - 1) / 2.0);
    blocks_free(&b);
}

/* Correlated samples: the error of the series itself, within its own
   uncertainty. */
static void test_error(void)
{
    enum { COUNT = 100000 };
    static double x[COUNT];
    struct blocks b;
    struct random r;
    random_seed(&r, 3);
    UNIT_TRUE(blocks_create(&b, 1));
    for (size_t n = 0; n < COUNT; ++n) {
        x[n] = random_normal(&r) + (n > 0 ? 0.9 * x[n - 1] : 0);
        blocks_add(&b, &x[n]);
    }
    /* sd of the sum: 1 / (1 - 0.9) for each root of a sample */
    const struct blocks_average a = blocks_average(&b, 0);
    UNIT_NEAR(a.error, 10 / sqrt(COUNT), 0.2 * 10 / sqrt(COUNT));
    UNIT_NEAR(a.mean, 0, 4 * a.error);
    const struct blocks_average whole = blocks_average_of(COUNT, x);
    UNIT_NEAR(whole.error, a.error, 0.3 * a.error);
    UNIT_NEAR(whole.mean, a.mean, a.error);
    blocks_free(&b);
}

/* Whole blocks from outside, which double with the others. */
static void test_appended(void)
{
    struct blocks b;
    double total = 0;
    UNIT_TRUE(blocks_create(&b, 1));
    for (size_t n = 0; n < 3000; ++n) {
        const double sum = (double)b.per * 7;
        total += (double)b.per;
        blocks_append(&b, &sum);
    }
    UNIT_EQUAL((double)(b.count * b.per), total);
    UNIT_EQUAL(blocks_average(&b, 0).mean, 7);
    UNIT_TRUE(b.count < BLOCKS_MOST);
    blocks_free(&b);
}

static void test_few(void)
{
    struct blocks b;
    UNIT_TRUE(blocks_create(&b, 1));
    UNIT_TRUE(isnan(blocks_average(&b, 0).error));
    blocks_add(&b, (double[]){3});
    UNIT_EQUAL(blocks_average(&b, 0).mean, 3);
    UNIT_TRUE(isnan(blocks_average(&b, 0).error));
    blocks_free(&b);
}

int main(void)
{
    return unit_run(
        "blocks",
        (struct unit_test[]){
            {"blocks that are joined keep their sums", test_joined},
            {"the error is that of the series", test_error},
            {"whole blocks can be appended", test_appended},
            {"one value has no error", test_few},
            {0}});
}
