/* The hidden tests of exercise 08b, "One more row in the tableau". */

#include "examiner/check.h"

enum { MOST_STAGES = 8, MOST = 12 };

struct table {
    size_t stages;
    double a[MOST_STAGES * MOST_STAGES], b[MOST_STAGES];
};

/* In the suite: the student's step under a law, the student's table, and a
   drawn one. */
size_t step_under(void (*law)(size_t n, double t, const double y[],
                              double dy[]),
                  const struct table *table, size_t n, double t, double h,
                  double y[]);
struct table new_method(void);
struct table draw_table(size_t stages);

static void check(double got, double expected, double tolerance,
                  const char *quantity, const char *input)
{
    CHECK_NEAR(got, .quantity = quantity, .input = input,
               .expected = expected, .tolerance = tolerance,
               .because = "some epsilons of all that is added up");
}

/* A cubic in t, whose integral is exact, over any step. */
static double cubic[4];

static void grows(size_t n, double t, const double y[], double dy[])
{
    (void)y;
    for (size_t i = 0; i < n; ++i)
        dy[i] = ((cubic[3] * t + cubic[2]) * t + cubic[1]) * t + cubic[0];
}

static double integral_to(double t)
{
    double sum = 0.0;
    for (int k = 4; k > 0; --k)
        sum = (sum + cubic[k - 1] / k) * t;
    return sum;
}

CHECK_TIMES(20, test_cubics, i)
{
    const struct table table = new_method();
    const double t = check_draw(-2.0, 2.0), h = check_draw(-2.0, 2.0);
    double y[2] = {check_draw(-1.0, 1.0), 0.0}, begin = y[0];
    for (int k = 0; k < 4; ++k)
        cubic[k] = check_draw(-1.0, 1.0);
    (void)step_under(grows, &table, 1, t, h, y);
    check(y[0], begin + integral_to(t + h) - integral_to(t), 2e-13,
          "y by the 3/8 rule",
          check_text(
              "y' = %g + %g t + %g t^2 + %g t^3, y = %g at t = %g, h = %g",
              cubic[0], cubic[1], cubic[2], cubic[3], begin, t, h));
}

/* A top: three numbers that act on each other. */
static void top(size_t n, double t, const double y[], double dy[])
{
    (void)n;
    dy[0] = (1.0 + t) * y[1] * y[2];
    dy[1] = -2.0 * y[2] * y[0];
    dy[2] = t * y[0] * y[1];
}

/* The last two of the stages use the first ones and not each other: they
   may change places. */
CHECK_TIMES(20, test_places, i)
{
    const size_t s = (size_t)check_draw_whole(3, MOST_STAGES);
    struct table one = draw_table(s), other;
    one.a[s * s - 2] = 0.0;
    other = one;
    for (size_t j = 0; j < s - 2; ++j) {
        other.a[s * (s - 2) + j] = one.a[s * (s - 1) + j];
        other.a[s * (s - 1) + j] = one.a[s * (s - 2) + j];
    }
    other.b[s - 2] = one.b[s - 1];
    other.b[s - 1] = one.b[s - 2];
    double y[4], z[4];
    for (int k = 0; k < 3; ++k)
        z[k] = y[k] = check_draw(-1.0, 1.0);
    const double t = check_draw(-1.0, 1.0), h = check_draw(0.05, 0.3);
    const double asked = (double)step_under(top, &one, 3, t, h, y);
    (void)step_under(top, &other, 3, t, h, z);
    const char *input =
        check_text("%zu stages of a drawn table, h = %g; the last two do "
                   "not use each other and change places",
                   s, h);
    for (int k = 0; k < 3; ++k)
        check(z[k], y[k], 1e-12, check_text("y[%d]", k), input);
    check(asked, (double)s, 0.0, "how often the slopes were asked", input);
}

/* The new method and the exact solution of two numbers that act on each
   other: x = r cos, y = r sin with r' = -r^2, r = 1/(1 + t). */
static void spiral(size_t n, double t, const double y[], double dy[])
{
    const double r = hypot(y[0], y[1]);
    (void)n;
    (void)t;
    dy[0] = -r * y[0] - y[1];
    dy[1] = -r * y[1] + y[0];
}

static double spiral_error(const struct table *table, double angle,
                           double end, int steps)
{
    double y[3] = {cos(angle), sin(angle), 0.0};
    for (int i = 0; i < steps; ++i)
        (void)step_under(spiral, table, 2, 0.0, end / steps, y);
    return hypot(y[0] - cos(angle + end) / (1.0 + end),
                 y[1] - sin(angle + end) / (1.0 + end));
}

CHECK_TIMES(5, test_spiral, i)
{
    const struct table table = new_method();
    const double angle = check_draw(0.0, 6.0);
    const double end = check_draw(1.5, 2.5);
    check(log2(spiral_error(&table, angle, end, 40) /
               spiral_error(&table, angle, end, 80)),
          4.0, 0.15, "order, from 40 steps and 80",
          check_text("a spiral inwards from the angle %g to t = %g", angle,
                     end));
}

const struct check_test check_hidden[] = {
    {"cubics are integrated exactly", test_cubics, 2, 0},
    {"stages may change places", test_places, 2, 0},
    {"order 4 on a spiral", test_spiral, 1, 0},
    {0}};
