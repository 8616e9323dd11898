/* The hidden tests of exercise 03b, "An error bar that keeps its word". */

#include "examiner/check.h"
#include "toolbox/random.h"
#include "call.h"

enum { N = 8000, FEW = 20 };

static double x[N], other[N];

/* Plus or minus one, which changes its sign with probability p: the memory
   is (1 - 2p)^t. Returns the true standard error of the mean. */
static double draw_signs(double p)
{
    const double a = 1.0 - 2.0 * p;
    struct random r;
    random_seed(&r, (uint64_t)check_draw_whole(0, 1000000000));
    x[0] = random_uniform(&r) < 0.5 ? -1.0 : 1.0;
    for (size_t i = 1; i < N; ++i)
        x[i] = random_uniform(&r) < p ? -x[i - 1] : x[i - 1];
    return sqrt(((1.0 + a) / (1.0 - a) - a / (2.0 * N * p * p)) / N);
}

/* As in the suite: the ratio scatters by 0.04 with twenty blocks. */
static void test_signs(void)
{
    double squares = 0.0;
    for (int i = 0; i < FEW; ++i) {
        double error = NAN;
        const double sigma = draw_signs(check_draw(0.06, 0.8));
        mean_and_error(N, x, &error);
        squares += error / sigma * (error / sigma) / FEW;
    }
    CHECK_NEAR(
        sqrt(squares),
        .quantity =
            "your error, in true standard errors (root of the mean square)",
        .input = check_text("%d series of -1 and 1", FEW), .expected = 1.0,
        .tolerance = 0.2,
        .because = "with twenty blocks and more this scatters by 0.04",
        .equation = "eq:inefficiency");
}

CHECK_TIMES(6, test_units, i)
{
    const double unit = i % 2 ? -1e6 : 1e-6;
    double error = NAN, scaled = NAN;
    draw_signs(check_draw(0.06, 0.8));
    for (size_t k = 0; k < N; ++k)
        other[k] = unit * (x[k] + 7.0);
    mean_and_error(N, x, &error);
    mean_and_error(N, other, &scaled);
    CHECK_NEAR(
        scaled / fabs(unit) / error,
        .quantity = "error in other units, by the error",
        .input = check_text(
            "a series of -1 and 1, and the same plus 7 and times %g", unit),
        .expected = 1.0, .tolerance = 1e-6, .because = "roundings");
}

const struct check_test check_hidden[] = {
    {"a sign has an error like other values", test_signs, 2, 0},
    {"other units and another zero change nothing", test_units, 1, 0},
    {0}};
