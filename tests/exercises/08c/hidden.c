/* The hidden tests of exercise 08c, "Measure an order". */

#include "examiner/check.h"
#include "call.h"

enum { RUNS = 6 };

static void check(double got, double expected, double tolerance,
                  const char *quantity, const char *input)
{
    CHECK_NEAR(got, .quantity = quantity, .input = input,
               .expected = expected, .tolerance = tolerance,
               .because = "some epsilons of four logarithms");
}

/* C h^p (1 + D h): the slope between two steps is p and what the second
   factor adds to it. */
struct series {
    double p, d, h[RUNS + 1], error[RUNS + 1];
};

static struct series draw_series(void)
{
    struct series s = {.p = check_draw(1.0, 6.0),
                       .d = check_draw(0.0, 4.0)};
    const double c = check_draw(0.1, 9.0), shrink = check_draw(1.3, 2.5);
    for (int i = 0; i <= RUNS; ++i) {
        s.h[i] = pow(shrink, -i);
        s.error[i] = c * pow(s.h[i], s.p) * (1.0 + s.d * s.h[i]);
    }
    return s;
}

static double slope_of(const struct series *s, int coarse)
{
    const double *h = s->h + coarse;
    return s->p + log((1.0 + s->d * h[0]) / (1.0 + s->d * h[1])) /
                      log(h[0] / h[1]);
}

static const char *text_of(const struct series *s)
{
    return check_text(
        "errors as h^%g (1 + %g h), steps from 1 s down to %g s", s->p,
        s->d, s->h[RUNS - 1]);
}

CHECK_TIMES(40, test_series, i)
{
    const struct series s = draw_series();
    const double last = slope_of(&s, RUNS - 2);
    const double change = fabs(slope_of(&s, RUNS - 3) - last);
    double order = -99.0;
    const enum verdict verdict =
        measure_order(RUNS, s.h, s.error, 1e-16, &order);
    check(order, last, 1e-12, "*order", text_of(&s));
    if (fabs(change - 0.2) > 1e-3)
        check((double)verdict, change > 0.2 ? NOT_YET : MEASURED, 0.0,
              "what is returned (0 TOO_FEW, 1 NOT_YET, 2 MEASURED)",
              text_of(&s));
}

/* Powers of two as units change no logarithm's difference but by rounding,
   and no verdict at all. */
CHECK_TIMES(20, test_units, i)
{
    struct series s = draw_series(), other = s;
    const double m = ldexp(1.0, check_draw_whole(-60, 60));
    const double second = ldexp(1.0, check_draw_whole(-60, 60));
    const double rounding =
        fabs(s.error[check_draw_whole(0, RUNS - 1)]) * 0.7e-3;
    double order = -99.0, same = -99.0;
    for (int k = 0; k <= RUNS; ++k) {
        other.h[k] *= second;
        other.error[k] *= k % 2 ? m : -m;
    }
    const enum verdict one =
        measure_order(RUNS, s.h, s.error, rounding, &order);
    const enum verdict two =
        measure_order(RUNS, other.h, other.error, m * rounding, &same);
    check((double)two, (double)one, 0.0,
          "what is returned, in the other units", text_of(&s));
    check(isnan(same), isnan(order), 0.0, "is *order NAN? (1 yes, 0 no)",
          text_of(&s));
    if (!isnan(order))
        check(same, order, 1e-11, "*order, in the other units",
              text_of(&s));
}

/* How many are of use when the limit lies between two errors. */
CHECK_TIMES(20, test_limit, i)
{
    const struct series s = draw_series();
    const int useful = check_draw_whole(0, RUNS);
    const double limit = useful == 0
                             ? 2.0 * s.error[0]
                             : sqrt(s.error[useful - 1] * s.error[useful]);
    double order = -99.0;
    const enum verdict verdict =
        measure_order(RUNS, s.h, s.error, limit / 1000.0, &order);
    const char *input =
        check_text("%s, of which %d are of use", text_of(&s), useful);
    if (useful < 2) {
        check((double)verdict, TOO_FEW, 0.0,
              "what is returned (0 TOO_FEW, 1 NOT_YET, 2 MEASURED)", input);
    } else {
        check(order, slope_of(&s, useful - 2), 1e-12, "*order", input);
    }
}

const struct check_test check_hidden[] = {
    {"an error of two terms", test_series, 2, 0},
    {"errors and steps in any unit", test_units, 1, 0},
    {"where rounding begins", test_limit, 2, 0},
    {0}};
