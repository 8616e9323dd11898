/* The hidden tests of exercise 12c, "Leave a force out". */

#include "examiner/check.h"
#include "call.h"

static const char *text_of(double push, double stretch, double time)
{
    return check_text("push %.15g m/s^2, stretch %.15g/s, time %.15g s",
                      push, stretch, time);
}

static double bound_of(double push, double stretch, double time)
{
    double budget = 1.0, bound = -99.0;
    (void)leave_out(push, stretch, time, &budget, &bound);
    return bound;
}

static void check(double got, double expected, double tolerance,
                  const char *quantity, const char *input)
{
    CHECK_NEAR(got, .quantity = quantity, .input = input,
               .expected = expected, .tolerance = tolerance,
               .because = "what was asked for, twice");
}

/* cosh(2 x) - 1 = 2 (cosh(x) - 1) (cosh(x) + 1). */
CHECK_TIMES(50, test_twice, i)
{
    const double push = pow(10.0, check_draw(-9.0, 3.0));
    const double stretch = pow(10.0, check_draw(-5.0, 5.0));
    const double time = pow(10.0, check_draw(-6.0, 1.0)) / stretch;
    const double once = bound_of(push, stretch, time);
    const double expected =
        2.0 * once * (2.0 + stretch * stretch * once / push);
    check(bound_of(push, stretch, 2.0 * time), expected, 3e-12 * expected,
          "*bound after twice the time, in m",
          text_of(push, stretch, time));
}

/* Powers of two as units; the budget and the verdict go with them. */
CHECK_TIMES(50, test_units, i)
{
    const double m = ldexp(1.0, check_draw_whole(-60, 60));
    const double s = ldexp(1.0, check_draw_whole(-60, 60));
    const double push = check_draw(0.1, 9.0);
    const double stretch = i % 5 ? check_draw(0.01, 3.0) : 0.0;
    const double time = check_draw(0.1, 3.0);
    const double share = check_draw(0.2, 1.8);
    double bound = bound_of(push, stretch, time), other = -99.0;
    double budget = share * bound, rest = m * share * bound;
    if (fabs(share - 1.0) < 1e-3)
        return;
    const bool may = leave_out(push, stretch, time, &budget, &bound);
    const bool too =
        leave_out(push * m / (s * s), stretch / s, time * s, &rest, &other);
    const char *input = text_of(push, stretch, time);
    check(may, share > 1.0, 0.0, "may it go? (1 yes, 0 no)", input);
    check(too, may, 0.0, "may it go, in other units? (1 yes, 0 no)", input);
    check(other / m, bound, 2e-12 * bound, "*bound, in other units", input);
    check(rest / m, budget, 1e-11 * bound, "*budget, in other units",
          input);
}

/* A constant push on an oscillator moves it by push (1 - cos(w t))/w^2 at
   most, one on a body that flies freely by push t^2/2, and friction slows
   one down: never is the bound less than what happens. */
CHECK_TIMES(50, test_happens, i)
{
    const double push = check_draw(0.01, 5.0);
    const double w = check_draw(0.1, 3.0), t = check_draw(0.1, 5.0);
    const double swing = sin(0.5 * w * t) / w;
    const double damped = push * (t + expm1(-w * t) / w) / w;
    const double held = bound_of(push, w, t);
    const double free = bound_of(push, 0.0, t);
    check(held >= 2.0 * push * swing * swing, 1.0, 0.0,
          "is the bound at least what happens? (1 yes, 0 no)",
          check_text("an oscillator of %g rad/s: %s", w,
                     text_of(push, w, t)));
    check(
        free >= damped, 1.0, 0.0,
        "is the bound at least what happens? (1 yes, 0 no)",
        check_text("friction of c/m = %g/s: %s", w, text_of(push, 0.0, t)));
    check(held >= free, 1.0, 0.0,
          "is the bound larger with stretch? (1 yes, 0 no)",
          text_of(push, w, t));
}

const struct check_test check_hidden[] = {
    {"the bound after two equal times", test_twice, 2, 0},
    {"pushes and budgets in any unit", test_units, 1, 0},
    {"never less than what happens", test_happens, 1, 0},
    {0}};
