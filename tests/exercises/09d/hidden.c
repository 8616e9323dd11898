/* The hidden tests of 09d, "Ellipses, and kicks from the others". */

#include "examiner/check.h"
#include "call.h"

static void draw(double gm[2], double x[2][3], double v[2][3])
{
    for (int i = 0; i < 2; ++i) {
        gm[i] = check_draw(1e-4, 1e-2);
        for (int k = 0; k < 3; ++k)
            x[i][k] = v[i][k] = check_draw(-0.1, 0.1);
    }
    x[0][0] += 1.0;
    v[0][1] += 1.0;
    x[1][1] += 2.0;
    v[1][0] += 0.7;
}

static void check(double got, double expected, const char *what)
{
    CHECK_NEAR(got, .quantity = what, .input = "two planets, drawn",
               .expected = expected, .tolerance = 1e-12,
               .because = "the roundings of a step");
}

CHECK_TIMES(10, test_order, i)
{
    double gm[2], x[2][3], v[2][3], mg[2], y[2][3], w[2][3];
    draw(gm, x, v);
    for (int k = 0; k < 6; ++k) {
        mg[k % 2] = gm[1 - k % 2];
        y[k / 3][k % 3] = x[1 - k / 3][k % 3];
        w[k / 3][k % 3] = v[1 - k / 3][k % 3];
    }
    ellipses_and_kicks(2, gm, 1.0, 0.3, x, v);
    ellipses_and_kicks(2, mg, 1.0, 0.3, y, w);
    for (int k = 0; k < 6; ++k)
        check(w[k / 3][k % 3], v[1 - k / 3][k % 3],
              "velocity with the planets in the other order");
}

CHECK_TIMES(10, test_units, i)
{
    double gm[2], x[2][3], v[2][3], y[2][3], w[2][3];
    draw(gm, x, v);
    double other[2] = {64.0 * gm[0], 64.0 * gm[1]};
    for (int k = 0; k < 6; ++k) {
        y[k / 3][k % 3] = 16.0 * x[k / 3][k % 3];
        w[k / 3][k % 3] = 2.0 * v[k / 3][k % 3];
    }
    ellipses_and_kicks(2, gm, 1.0, 0.3, x, v);
    ellipses_and_kicks(2, other, 64.0, 2.4, y, w);
    for (int k = 0; k < 6; ++k)
        check(w[k / 3][k % 3] / 2.0, v[k / 3][k % 3],
              "velocity in other units");
}

const struct check_test check_hidden[] = {
    {"the order of the planets does not matter", test_order, 1, 0},
    {"other units have the same orbits", test_units, 1, 0},
    {0}};
