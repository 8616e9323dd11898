/* Sums in blocks: nothing is lost when they are joined, and the error is
   that of the whole series. */
#include "unit.h"

#include "box/blocks.h"
#include "line/statistics.h"
#include "toolbox/random.h"

/* Samples 0, 1, 2, ... : every full block is known. */
TEST(test_joined, "blocks that are joined keep their sums")
{
    CREATED(blocks, b, 2);
    for (size_t n = 0; n < 5000; ++n)
        blocks_add(&b, (double[]){(double)n, 1});
    UNIT_EQUAL(b.per, 16); /* 256 to 511 blocks */
    UNIT_EQUAL(b.count, 5000 / 16);
    UNIT_EQUAL(b.filled, 5000 % 16);
    for (size_t i = 0; i < b.count; ++i) {
        UNIT_EQUAL(b.sum[2 * i], 16 * 16 * (double)i + 120);
        UNIT_EQUAL(b.sum[2 * i + 1], 16);
    }
    UNIT_EQUAL(blocks_average(&b, 1).mean, 1);
    UNIT_EQUAL(blocks_average(&b, 1).error, 0);
    UNIT_EQUAL(blocks_average(&b, 0).mean, (5000 / 16 * 16 - 1) / 2.0);
}

/* Correlated samples: the error of the series itself, within its own
   uncertainty. */
TEST(test_error, "the error is that of the series")
{
    enum { COUNT = 100000 };
    static double x[COUNT];
    SEEDED(r, 3);
    CREATED(blocks, b, 1);
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
}

/* Whole blocks from outside, which double with the others. */
TEST(test_appended, "whole blocks can be appended")
{
    double total = 0;
    CREATED(blocks, b, 1);
    for (size_t n = 0; n < 3000; ++n) {
        const double sum = (double)b.per * 7;
        total += (double)b.per;
        blocks_append(&b, &sum);
    }
    UNIT_EQUAL(b.count * b.per, total);
    UNIT_EQUAL(blocks_average(&b, 0).mean, 7);
    UNIT_TRUE(b.count < BLOCKS_MOST);
}

TEST(test_few, "one value has no error")
{
    CREATED(blocks, b, 1);
    UNIT_TRUE(isnan(blocks_average(&b, 0).error));
    blocks_add(&b, (double[]){3});
    UNIT_EQUAL(blocks_average(&b, 0).mean, 3);
    UNIT_TRUE(isnan(blocks_average(&b, 0).error));
}

/* Nothing drifts: the law of a normal number over the root of the smaller
   of two chi-squares of 15, each over 15. Its square has the mean 1.1850^2,
   and beyond 3 are 0.01503 (both from the law's integral); of 20000 that is
   4 standard deviations. Beyond 6 are 4.8e-5: 0.96 are expected, and more
   than 6 come once in 10000. */
TEST(test_steady, "a steady series drifts as the law says")
{
    enum { TIMES = 20000, LENGTH = 48 };
    double x[LENGTH], square = 0, fourth = 0;
    int beyond = 0, far = 0;
    SEEDED(r, 4);
    for (int t = 0; t < TIMES; ++t) {
        for (int i = 0; i < LENGTH; ++i)
            x[i] = 5 + random_normal(&r);
        const double z = blocks_average_of(LENGTH, x).drift;
        square += z * z / TIMES;
        fourth += z * z * z * z / TIMES;
        beyond += fabs(z) > 3;
        far += fabs(z) > BLOCKS_STEADY;
    }
    UNIT_NEAR(square, 1.185042 * 1.185042,
              4 * sqrt((fourth - square * square) / TIMES));
    UNIT_NEAR(beyond, 0.01503 * TIMES, 4 * sqrt(0.01503 * TIMES));
    UNIT_TRUE(far <= 6);
}

/* A step of ten standard deviations within a third, at value 144 or 400 of
   480: of the step, 9 and 5 are seen, and the steady third's error is the
   root of 1/160 to 1/7 of itself, so that twice that is allowed. The other
   third's scatter would excuse it. */
TEST(test_step, "a step is a drift, wherever it is")
{
    double x[480];
    SEEDED(r, 5);
    for (int at = 144; at <= 400; at += 256)
        for (int up = -1; up <= 1; up += 2) {
            for (int i = 0; i < 480; ++i)
                x[i] = 100 + up * (i < at ? 0 : 10) + random_normal(&r);
            const double z = up * blocks_average_of(480, x).drift;
            UNIT_TRUE(z > (at == 144 ? 9 : 5) / (2 * sqrt(2.0 / 160)));
        }
}

/* Too few values, a part in which nothing happened, and parts that are all
   alike but for rounding. */
TEST(test_no_drift, "no drift where there is no error")
{
    double x[100];
    for (int i = 0; i < 100; ++i)
        x[i] = i;
    UNIT_TRUE(isnan(blocks_average_of(47, x).drift));
    UNIT_TRUE(!isnan(blocks_average_of(48, x + 1).drift));
    UNIT_TRUE(isnan(blocks_average_of(48, x).drift)); /* x[0] is 0 */
    for (int i = 0; i < 100; ++i)
        x[i] = i < 50 ? 3 + i % 3 * 1e-15 : i;
    UNIT_TRUE(isnan(blocks_average_of(48, x).drift));
    UNIT_TRUE(isnan(blocks_average_of(96, x).drift));
    UNIT_TRUE(!isnan(blocks_average_of(48, x + 50).drift));
}

/* A little noise on a large mean is no rounding: of values round 1e8 that
   scatter by 1 the drift is as known as of values round 0, and obeys the
   same law; of those round 1e11, where the scatter is 1e-11 of the mean,
   not. */
TEST(test_large_mean, "noise on a large mean is noise")
{
    double x[48], y[48];
    SEEDED(r, 6);
    for (int t = 0; t < 20; ++t) {
        for (int i = 0; i < 48; ++i) {
            x[i] = 8 + random_normal(&r);
            y[i] = x[i] + 1e8;
        }
        /* Adding 1e8 rounds by 1e-8, of a scatter of 1. */
        const double z = blocks_average_of(48, x).drift;
        UNIT_NEAR(blocks_average_of(48, y).drift, z, 1e-6);
        for (int i = 0; i < 48; ++i)
            y[i] = x[i] + 1e11;
        UNIT_TRUE(isnan(blocks_average_of(48, y).drift));
    }
}

/* Two samples have an error, half of what they differ by; one has none. */
TEST(test_two_samples, "two have")
{
    const double two[] = {3, 7};
    const struct blocks_average a = blocks_average_of(2, two);
    UNIT_EQUAL(a.mean, 5);
    UNIT_NEAR(a.error, 2, 1e-15);
    UNIT_TRUE(isnan(a.drift) && isnan(blocks_average_of(1, two).error));
}
