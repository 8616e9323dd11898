/* The hidden tests of exercise 01a, "Two bodies meet". */

#include "examiner/check.h"
#include "call.h"

static const char *input(double u1, double u2, double im1, double im2)
{
    return check_text(
        "u1 = %g m/s, u2 = %g m/s, im1 = %g /kg, im2 = %g /kg", u1, u2, im1,
        im2);
}

static void check_pair(const double v[2], const double u[2],
                       const double im[2], const double expected[2],
                       double tolerance, const char *because)
{
    for (int i = 0; i < 2; ++i)
        CHECK_NEAR(v[i], .quantity = check_text("v[%d]", i), .unit = "m/s",
                   .input = input(u[0], u[1], im[0], im[1]),
                   .expected = expected[i], .tolerance = tolerance,
                   .because = because);
}

/* Made from the answer, as in the suite: the centre's velocity c, and the
   same momentum for both as seen from there. Units are powers of two, which
   round nothing. An atom has some 2^86 per kg, the Moon 2^-76. */
CHECK_TIMES(40, test_units, i)
{
    const int fast = check_draw_whole(-60, 60);
    const int light = check_draw_whole(-80, 80);
    const double a = check_draw_whole(1, 30);
    const double b = check_draw_whole(1, 30);
    const double c = check_draw_whole(-50, 50);
    const double w = i % 2 ? -2.0 : 2.0;
    const double im[] = {ldexp(a, light), ldexp(b, light)};
    const double u[] = {ldexp(c + w * a, fast), ldexp(c - w * b, fast)};
    const double after[] = {ldexp(c - w * a, fast), ldexp(c + w * b, fast)};
    double v[] = {NAN, NAN};
    velocities_after(u[0], u[1], im[0], im[1], v);
    check_pair(v, u, im, after,
               12.0 * DBL_EPSILON * fmax(fabs(u[0]), fabs(u[1])),
               "12 epsilons of the faster velocity");
}

/* Who collides twice moves as before. The second collision starts from
   velocities up to three times as large, with errors as large as the
   suite allows; it may triple these and adds its own. */
CHECK_TIMES(40, test_twice, i)
{
    const double u[] = {check_draw(-9.0, 9.0), check_draw(-9.0, 9.0)};
    const double im[] = {i % 8 == 3 ? 0.0 : check_draw(1e-3, 1e3),
                         i % 8 == 7 ? 0.0 : check_draw(1e-3, 1e3)};
    double v[] = {NAN, NAN}, back[] = {NAN, NAN};
    velocities_after(u[0], u[1], im[0], im[1], v);
    velocities_after(v[0], v[1], im[0], im[1], back);
    check_pair(back, u, im, u,
               412.0 * DBL_EPSILON * fmax(fabs(u[0]), fabs(u[1])),
               "72 epsilons of the faster velocity: two collisions");
}

const struct check_test check_hidden[] = {
    {"atoms and moons collide like bodies of a kilogram", test_units, 1, 0},
    {"a second collision undoes the first", test_twice, 1, 0},
    {0}};
