/* The hidden tests of exercise 09e, "The small ones count". */

#include "examiner/check.h"
#include "call.h"

enum { N = 101 };

/* Numbers of sizes from 1e-12 to 1e4, and their sum of sizes. */
static double draw(double part[])
{
    double sizes = 0.0;
    for (size_t i = 0; i < N; ++i) {
        part[i] = check_draw(-9.0, 9.0) * pow(10.0, check_draw(-12.0, 3.0));
        sizes += fabs(part[i]);
    }
    return sizes;
}

CHECK_TIMES(20, test_backwards, i)
{
    double part[N], back[N];
    const double sizes = draw(part);
    for (size_t k = 0; k < N; ++k)
        back[k] = part[N - 1 - k];
    const double forth = sum_up(N, part);
    const double twice = N * DBL_EPSILON;
    CHECK_NEAR(sum_up(N, back), .quantity = "sum in the opposite order",
               .input = "101 numbers of many sizes", .expected = forth,
               .tolerance = 4.0 * DBL_EPSILON * fabs(forth) +
                            2.0 * twice * twice * sizes,
               .because = "what was asked for, each time");
}

CHECK_TIMES(20, test_units, i)
{
    double part[N], other[N];
    draw(part);
    const int unit = check_draw_whole(-300, 300);
    for (size_t k = 0; k < N; ++k)
        other[k] = ldexp(part[k], unit);
    CHECK_NEAR(ldexp(sum_up(N, other), -unit),
               .quantity = "sum in other units",
               .input = check_text("101 numbers, times 2^%d", unit),
               .expected = sum_up(N, part),
               .because = "a power of two rounds nothing");
}

const struct check_test check_hidden[] = {
    {"backwards the sum is the same", test_backwards, 1, 0},
    {"in other units the sum is the same", test_units, 1, 0},
    {0}};
