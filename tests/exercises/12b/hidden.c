/* Further tests of exercise 12b, for the lecturer: other units, a row of
   tolerances, and a row of roundings. */

#include "examiner/check.h"
#include <math.h>
#include <stdbool.h>

enum verdict { OUT_OF_REACH, TOO_FINE, NO_ORDER, CHOSEN };

enum verdict choose_step(double p, const double h[2], const double error[2],
                         double rounding, double tolerance, double *step);

/* Two runs by a method of order p, which they show. */
struct runs {
    double p, h[2], error[2];
};

static struct runs draw_runs(void)
{
    const double quotient = check_draw(1.3, 5.0);
    struct runs r = {.p = check_draw(1.0, 8.0)};
    r.h[1] = check_draw(0.01, 1.0);
    r.h[0] = quotient * r.h[1];
    r.error[1] = -check_draw(0.5, 2.0);
    r.error[0] = pow(quotient, r.p + check_draw(-0.25, 0.25));
    r.error[0] *= fabs(r.error[1]);
    return r;
}

static const char *text_of(const struct runs *r, double tolerance)
{
    return check_text("order %g, steps %.15g s and %.15g s, errors %.15g m "
                      "and %.15g m, tolerance %.15g m",
                      r->p, r->h[0], r->h[1], r->error[0], r->error[1],
                      tolerance);
}

static bool check(double got, double expected, double tolerance,
                  const char *quantity, const char *input,
                  const char *question)
{
    return CHECK_NEAR(got, .quantity = quantity, .input = input,
                      .expected = expected, .tolerance = tolerance,
                      .because =
                          "some epsilons of two logarithms, or exact",
                      .equation = "eq:chosen-step", .question = question);
}

static const char returned[] =
    "what is returned (0 OUT_OF_REACH, 1 TOO_FINE, 2 NO_ORDER, 3 CHOSEN)";

/* Powers of two as units. */
static void test_units(void)
{
    for (int i = 0; i < 40; ++i) {
        const struct runs r = draw_runs();
        const double m = ldexp(1.0, check_draw_whole(-60, 60));
        const double second = ldexp(1.0, check_draw_whole(-60, 60));
        const double tolerance = pow(10.0, check_draw(-9.0, 1.0));
        const double rounding = check_draw(0.0, 0.5) * tolerance * 0.2;
        const double h[2] = {second * r.h[0], second * r.h[1]};
        const double error[2] = {m * r.error[0], m * r.error[1]};
        double step = -99.0, same = -99.0;
        const enum verdict one =
            choose_step(r.p, r.h, r.error, rounding, tolerance, &step);
        const enum verdict two =
            choose_step(r.p, h, error, m * rounding, m * tolerance, &same);
        const char *input = text_of(&r, tolerance);
        static const char question[] =
            "Is there a number with a unit in your program?";
        if (!check((double)two, (double)one, 0.0, returned, input,
                   question) ||
            !check(isnan(same), isnan(step), 0.0,
                   "is *step NAN? (1 yes, 0 no)", input, question) ||
            (!isnan(step) &&
             !check(same / second, step, 1e-12 * step,
                    "*step, in the other units", input, question)))
            return;
    }
}

/* A tolerance that is f^p times as large allows f times the step, until the
   larger step is reached. */
static void test_tolerances(void)
{
    for (int i = 0; i < 20; ++i) {
        const struct runs r = draw_runs();
        double step = -99.0, first = -99.0;
        const double tiny = 1e-6 * fabs(r.error[1]);
        if (!check(
                (double)choose_step(r.p, r.h, r.error, 0.0, tiny, &first),
                CHOSEN, 0.0, returned, text_of(&r, tiny),
                "Is there a reason to refuse?"))
            return;
        for (int k = 1; k <= 12; ++k) {
            const double f = 1.0 + k * k * check_draw(0.1, 1.0);
            const double tolerance = tiny * pow(f, r.p);
            const enum verdict verdict =
                choose_step(r.p, r.h, r.error, 0.0, tolerance, &step);
            const char *input = text_of(&r, tolerance);
            const double expected = f * first < r.h[0] ? f * first : r.h[0];
            if (!check((double)verdict, CHOSEN, 0.0, returned, input,
                       "Is there a reason to refuse?") ||
                !check(step, expected, 1e-12 * expected, "*step", input,
                       "How does the step change with the tolerance, and "
                       "where does that end?"))
                return;
        }
    }
}

/* The rounding grows, past the errors and the tolerance. */
static void test_roundings(void)
{
    for (int i = 0; i < 60; ++i) {
        const struct runs r = draw_runs();
        const double fine = fmin(fabs(r.error[0]), fabs(r.error[1]));
        const double tolerance = check_draw(0.1, 5.0) * fine;
        const double limit = check_draw(0.01, 1.0) *
                             (i % 2 ? fine : 3.0 * fmax(fine, tolerance));
        double step = -99.0;
        if (fabs(limit / fine - 1.0) < 1e-6 ||
            fabs(limit / tolerance - 1.0) < 1e-6)
            continue;
        const enum verdict expected = tolerance < limit ? OUT_OF_REACH
                                      : fine < limit    ? TOO_FINE
                                                        : CHOSEN;
        const enum verdict verdict =
            choose_step(r.p, r.h, r.error, 0.1 * limit, tolerance, &step);
        const char *input = check_text("%s, ten times the rounding %.15g m",
                                       text_of(&r, tolerance), limit);
        if (!check((double)verdict, (double)expected, 0.0, returned, input,
                   "What is the first reason to choose none?") ||
            !check(isnan(step), expected != CHOSEN, 0.0,
                   "is *step NAN? (1 yes, 0 no)", input,
                   "When is there a step, and when is there none?"))
            return;
    }
}

const struct check_test check_hidden[] = {
    {"errors and steps in any unit", test_units, 1, 0},
    {"a row of tolerances", test_tolerances, 2, 0},
    {"a row of roundings", test_roundings, 1, 0},
    {0}};
