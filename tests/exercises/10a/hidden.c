/* The hidden tests of exercise 10a, "A dashpot along the axis". */

#include "examiner/check.h"
#include "call.h"

static const char *input(double c, const struct body *a,
                         const struct body *b)
{
    return check_text("c = %g kg/s, a at (%g, %g, %g) m with (%g, %g, %g) "
                      "m/s, b at (%g, %g, %g) m with (%g, %g, %g) m/s",
                      c, a->x[0], a->x[1], a->x[2], a->v[0], a->v[1],
                      a->v[2], b->x[0], b->x[1], b->x[2], b->v[0], b->v[1],
                      b->v[2]);
}

static void check(double got, double expected, double tolerance,
                  const char *quantity, const char *text)
{
    CHECK_NEAR(got, .quantity = quantity, .input = text,
               .expected = expected, .tolerance = tolerance,
               .because = "16 epsilons of the terms");
}

static void draw(double x[3], double unit)
{
    for (int k = 0; k < 3; ++k)
        x[k] = check_draw_whole(-1000, 1000) * unit;
}

/* A flow that turns and widens about the origin, with whole numbers for its
   velocities, so that they are exact. */
static void carry(struct body *b, const double turn[3], double widen)
{
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        b->v[k] = widen * b->x[k] + (turn[l] * b->x[m] - turn[m] * b->x[l]);
    }
}

/* In a flow that widens at the rate h, the distance d grows by h d in a
   second, and the force is c h d along d, however the flow turns. */
static void check_flow(double unit, double widen)
{
    const double c = check_draw(0.1, 5.0);
    double turn[3], on_a[3] = {NAN, NAN, NAN}, on_b[3] = {NAN, NAN, NAN};
    double size = 0.0, square = 0.0;
    struct body a, b;
    draw(a.x, unit);
    draw(b.x, unit);
    draw(turn, 1.0);
    carry(&a, turn, widen);
    carry(&b, turn, widen);
    const char *text = input(c, &a, &b);
    const double heat = dashpot(c, &a, &b, on_a, on_b);
    for (int k = 0; k < 3; ++k) {
        size += c * fabs(b.v[k] - a.v[k]);
        square += (b.x[k] - a.x[k]) * (b.x[k] - a.x[k]);
    }
    const double tolerance = 16.0 * DBL_EPSILON * size;
    for (int k = 0; k < 3; ++k) {
        const double right = c * (widen * (b.x[k] - a.x[k]));
        check(on_a[k], right, tolerance, "force on a, in N", text);
        check(on_b[k], -right, tolerance, "force on b, in N", text);
    }
    check(heat, c * widen * widen * square,
          32.0 * DBL_EPSILON * size * size / c,
          "power turned into heat, in W", text);
}

CHECK_TIMES(30, test_wheel, i)
{
    check_flow(ldexp(1.0, check_draw_whole(-40, 40)), 0.0);
}

CHECK_TIMES(30, test_balloon, i)
{
    check_flow(ldexp(1.0, check_draw_whole(-40, 40)),
               check_draw_whole(-500, 500));
}

/* Whoever is called a: the forces are the same, and so is the heat. */
CHECK_TIMES(20, test_names, i)
{
    const double c = check_draw(0.1, 5.0);
    double f[2][3], g[2][3], size = 0.0;
    struct body a, b;
    draw(a.x, 0.25);
    draw(b.x, 0.25);
    draw(a.v, 1.0);
    draw(b.v, 1.0);
    const double heat = dashpot(c, &a, &b, f[0], f[1]);
    const double again = dashpot(c, &b, &a, g[1], g[0]);
    const char *text = input(c, &a, &b);
    for (int k = 0; k < 3; ++k)
        size += c * fabs(b.v[k] - a.v[k]);
    for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 3; ++k)
            check(f[j][k] - g[j][k], 0.0, 32.0 * DBL_EPSILON * size,
                  "difference of the force with the names exchanged, in N",
                  text);
    check(heat - again, 0.0, 64.0 * DBL_EPSILON * size * size / c,
          "difference of the power with the names exchanged, in W", text);
}

const struct check_test check_hidden[] = {
    {"a wheel that turns, on any scale", test_wheel, 2, 0},
    {"a balloon that widens", test_balloon, 1, 0},
    {"the names of the two bodies exchanged", test_names, 1, 0},
    {0}};
