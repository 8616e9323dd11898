/* The hidden tests of exercise 11b, "What leaves the cradle?". */

#include "examiner/check.h"
#include "call.h"

enum { LONG = 100 };

static void check(size_t n, const char *row, double got, double expected,
                  double tolerance, const char *quantity)
{
    CHECK_NEAR(got, .quantity = quantity,
               .input = check_text("%zu balls, %s", n, row),
               .expected = expected, .tolerance = tolerance,
               .because = "1e-11 of the largest that there is, or a number "
                          "that is exact");
}

/* check_draw has four digits, so that two pairs might meet at the same time
   by chance; here are twelve. */
static double draw_velocity(void)
{
    return check_draw(-3.0, 3.0) + 1e-4 * check_draw(0.1, 1.0) +
           1e-8 * check_draw(0.1, 1.0);
}

static void draw_balls(size_t n, double mass[], double v[])
{
    for (size_t i = 0; i < n; ++i) {
        mass[i] = check_draw(0.2, 5.0);
        v[i] = draw_velocity();
    }
}

/* Whatever happens in a long row, momentum and energy stay, and in the end
   nobody runs into anybody. */
CHECK_TIMES(4, test_long, k)
{
    static const size_t lengths[] = {10, 20, 35, LONG};
    const size_t n = lengths[k];
    double mass[LONG], v[LONG], before[2] = {0, 0}, after[2] = {0, 0};
    double most = 0.0, closest = INFINITY;
    draw_balls(n, mass, v);
    for (size_t i = 0; i < n; ++i) {
        before[0] += mass[i] * v[i];
        before[1] += mass[i] * v[i] * v[i];
        most += mass[i] * fabs(v[i]);
    }
    (void)cradle(n, mass, v);
    for (size_t i = 0; i < n; ++i) {
        after[0] += mass[i] * v[i];
        after[1] += mass[i] * v[i] * v[i];
        if (i > 0)
            closest = fmin(closest, v[i] - v[i - 1]);
    }
    check(n, "drawn", after[0], before[0], 1e-11 * most,
          "momentum at the end, in kg m/s");
    check(n, "drawn", after[1], before[1], 1e-11 * before[1],
          "twice the energy at the end, in J");
    check(n, "drawn", fmin(closest + 3e-9, 0.0), 0.0, 0.0,
          "speed of the fastest approach at the end, in m/s");
}

/* As many as there may be, and one flies in. */
static void test_most(void)
{
    for (size_t n = LONG - 3; n <= LONG; ++n) {
        double mass[LONG], v[LONG] = {0.0};
        for (size_t i = 0; i < n; ++i)
            mass[i] = 0.3;
        v[0] = check_draw(0.5, 3.0);
        const double in = v[0];
        const size_t count = cradle(n, mass, v);
        check(n, "equal", v[n - 1], in, 1e-11 * in,
              "velocity of the last one, in m/s");
        check(n, "equal", v[0], 0.0, 1e-11 * in,
              "velocity of the first one, in m/s");
        check(n, "equal", (double)count, n - 1.0, 0.0,
              "number of collisions");
    }
}

/* Left and right exchanged. */
CHECK_TIMES(30, test_mirror, k)
{
    const size_t n = (size_t)check_draw_whole(2, 9);
    double mass[2][LONG], v[2][LONG];
    draw_balls(n, mass[0], v[0]);
    for (size_t i = 0; i < n; ++i) {
        mass[1][n - 1 - i] = mass[0][i];
        v[1][n - 1 - i] = -v[0][i];
    }
    const size_t count = cradle(n, mass[0], v[0]);
    const size_t again = cradle(n, mass[1], v[1]);
    for (size_t i = 0; i < n; ++i)
        check(n, "drawn, and seen in a mirror", -v[1][n - 1 - i], v[0][i],
              3e-11, "velocity of a ball, in m/s");
    check(n, "drawn, and seen in a mirror", (double)again, (double)count,
          0.0, "number of collisions");
}

/* By somebody who walks along, with other clocks and weights. */
CHECK_TIMES(30, test_walk, k)
{
    const size_t n = (size_t)check_draw_whole(2, 9);
    const double unit = ldexp(1.0, check_draw_whole(-60, 60));
    const double kg = ldexp(1.0, check_draw_whole(-60, 60));
    const double walk = check_draw(-5.0, 5.0);
    double mass[2][LONG], v[2][LONG];
    draw_balls(n, mass[0], v[0]);
    for (size_t i = 0; i < n; ++i) {
        mass[1][i] = mass[0][i] * kg;
        v[1][i] = (v[0][i] - walk) * unit;
    }
    const size_t count = cradle(n, mass[0], v[0]);
    const size_t again = cradle(n, mass[1], v[1]);
    for (size_t i = 0; i < n; ++i)
        check(n, "drawn, and seen by somebody who walks",
              v[1][i] / unit + walk, v[0][i], 8e-11,
              "velocity of a ball, in m/s");
    check(n, "drawn, and seen by somebody who walks", (double)again,
          (double)count, 0.0, "number of collisions");
}

const struct check_test check_hidden[] = {
    {"long rows keep momentum and energy", test_long, 1, 0},
    {"as many balls as there may be", test_most, 1, 0},
    {"a row seen in a mirror", test_mirror, 1, 0},
    {"a row seen by somebody who walks along", test_walk, 1, 0},
    {0}};
