/* The hidden tests of exercise 01d, "Taking aim". */

#include "examiner/check.h"
#include "call.h"

static const char *input(double r1, double r2, double im1, double im2,
                         double deflection)
{
    return check_text("r1 = %g m, r2 = %g m, im1 = %g /kg, im2 = %g /kg, "
                      "deflection = %.10g rad",
                      r1, r2, im1, im2, deflection);
}

static void check(double b, const char *said, double expected,
                  double tolerance)
{
    CHECK_NEAR(b, .quantity = "impact parameter b, or -1", .unit = "m",
               .input = said, .expected = expected, .tolerance = tolerance,
               .because = "32 epsilons of r1 + r2, and none for a refusal");
}

/* A ball meets a pea 20 to 1000 times lighter. It is turned by a little
   less, or a little more, than the most that it can be turned: an angle
   whose sine is the ratio of the masses. The pea meets the ball as well,
   and any angle is within its reach. */
CHECK_TIMES(40, test_balls_and_peas, i)
{
    const double ball = check_draw(0.5, 20.0);
    const double pea = ball * check_draw_whole(20, 1000);
    const double both = 1.5;
    const double phi = check_draw(1.0, 1.5);
    const double blow = 2.0 * cos(phi) / (1.0 + pea / ball);
    const double soft = atan2(blow * sin(phi), 1.0 - blow * cos(phi));
    const double hard = 2.0 * cos(phi) / (1.0 + ball / pea);
    const double wide = atan2(hard * sin(phi), 1.0 - hard * cos(phi));
    const double much = asin(ball / pea) * (i % 2 ? 1.01 : 1.0) +
                        (i % 2 ? 0.0 : check_draw(0.1, 3.0));
    check(impact_parameter(1.0, 0.5, ball, pea, soft),
          input(1.0, 0.5, ball, pea, soft), both * sin(phi),
          32.0 * DBL_EPSILON * both);
    check(impact_parameter(0.5, 1.0, pea, ball, wide),
          input(0.5, 1.0, pea, ball, wide), both * sin(phi),
          32.0 * DBL_EPSILON * both);
    check(impact_parameter(1.0, 0.5, ball, pea, much),
          input(1.0, 0.5, ball, pea, much), -1.0, 0.0);
}

/* The two radii count only as a sum, the two masses only as a ratio, and a
   metre is as good as a mile. Whatever is refused is refused in any unit.
 */
CHECK_TIMES(40, test_units, i)
{
    const double r1 = check_draw(0.1, 2.0), r2 = check_draw(0.1, 2.0);
    const double im1 = check_draw(0.2, 5.0);
    const double im2 = check_draw(0.2, 5.0);
    const double angle = check_draw(0.1, 2.5);
    const double mile = ldexp(1.0, check_draw_whole(-60, 60));
    const double gram = ldexp(1.0, check_draw_whole(-90, 90));
    const double reach = im2 / im1 * sin(angle);
    if (fabs(reach - 1.0) < 0.05) /* too near to the edge to tell */
        return;
    const double b = impact_parameter(r1, r2, im1, im2, angle);
    const double c = impact_parameter(r2 * mile, r1 * mile, im1 * gram,
                                      im2 * gram, angle);
    const double expected = b == -1.0 ? -1.0 : b * mile;
    check(c, input(r2 * mile, r1 * mile, im1 * gram, im2 * gram, angle),
          expected,
          b == -1.0 ? 0.0 : 32.0 * DBL_EPSILON * (r1 + r2) * mile);
}

const struct check_test check_hidden[] = {
    {"balls and peas", test_balls_and_peas, 2, 0},
    {"miles and grams", test_units, 1, 0},
    {0}};
