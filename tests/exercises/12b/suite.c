/* The suite of exercise 12b: steps on paper, other orders, signs, large
   tolerances, errors of no order, rounding, runs that blew up, a method
   that is asked whether it is true, and drawn runs. */

#include "examiner/check.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

enum verdict { OUT_OF_REACH, TOO_FINE, NO_ORDER, CHOSEN };

enum verdict choose_step(double p, const double h[2], const double error[2],
                         double rounding, double tolerance, double *step);

struct runs {
    double p, h[2], error[2], rounding, tolerance;
};

struct result {
    enum verdict verdict;
    double step;
};

/* What the student's function says; an untouched step reads as -99. */
static struct result chosen(const struct runs *r)
{
    const struct runs q = *r;
    struct result result = {CHOSEN, -99.0};
    result.verdict = choose_step(q.p, q.h, q.error, q.rounding, q.tolerance,
                                 &result.step);
    return result;
}

static const char *input(const struct runs *r)
{
    return check_text("order %g; with steps of %.15g s and %.15g s errors "
                      "of %.15g m and %.15g m; rounding %g m, tolerance "
                      "%.15g m",
                      r->p, r->h[0], r->h[1], r->error[0], r->error[1],
                      r->rounding, r->tolerance);
}

/* ---- the slips ---- */

struct slip {
    const char *name;
    double value;
    const char *hint;
};

enum { SLIPS = 14 };

/* What the root of so high an order would have chosen. */
static double rooted(const struct runs *r, double p)
{
    const double ratio = r->tolerance / fabs(r->error[1]);
    return r->h[1] / 1.2 * exp(log(ratio) / p);
}

static void slips_of(const struct runs *r, double s,
                     struct slip slip[SLIPS])
{
    const double ratio = r->tolerance / fabs(r->error[1]);
    const double above = r->tolerance / fabs(r->error[0]);
    const double start = r->h[1] / 1.2, full = rooted(r, r->p);
    const double shown = (log(fabs(r->error[0])) - log(fabs(r->error[1]))) /
                         (log(r->h[0]) - log(r->h[1]));
    const struct slip all[SLIPS] = {
        {"sign-of-an-error", r->error[1] < 0.0 ? NAN : s,
         "Not a number. Which power of a negative number was taken? Does "
         "the sign of an error matter here?"},
        {"sign-of-an-error", r->error[1] < 0.0 ? r->h[0] : s,
         "What is a power of a negative number in C, and what does fmin "
         "make of that? Does the sign of an error matter here?"},
        {"beyond-the-larger-step", full,
         "This step is larger than any that was tried. What may happen "
         "there that the two errors do not tell?"},
        {"margin-forgotten", 1.2 * s,
         "Here the error is as large as the tolerance, if all goes well. "
         "Where is the margin?"},
        {"margin-the-wrong-way", 1.44 * s,
         "The margin makes the step larger here. Do more steps in the same "
         "time make them larger or smaller?"},
        {"margin-of-the-tolerance", full * 1.2 * pow(1.2, -1.0 / r->p),
         "Here the tolerance has the margin. How many times as many steps "
         "are these, and how many were wanted?"},
        {"factor-for-root", start * ratio,
         "The step changes by as much as the error here, as if the order "
         "were 1. By how much does the error of order p change when the "
         "step is halved?"},
        {"power-for-root", start * pow(ratio, r->p),
         "The error goes as a power of the step. How does the step go with "
         "the error then?"},
        {"upside-down", start * start / full,
         "The step became larger where it should become smaller, or the "
         "other way round. Which error is divided by which?"},
        {"through-the-larger-step", r->h[0] / 1.2 * pow(above, 1.0 / r->p),
         "This curve goes through the run with the larger step. Which of "
         "the two runs has less of the higher orders in its error?"},
        {"shown-order-taken", rooted(r, shown),
         "This takes the order that the two errors show for p. What was "
         "it to be used for?"},
        {"beyond-the-larger-step", r->h[0] * 1.2,
         "This step is larger than any that was tried. What may happen "
         "there that the two errors do not tell?"},
        {"margin-below-the-larger-step", r->h[0] / 1.2,
         "The curve allows the larger step and more. Is there a margin to "
         "be taken from what has been seen to do?"},
        {"not-beyond-the-smaller-step", r->h[1],
         "The larger of the two steps was tried as well. How large may the "
         "step be at most?"}};
    for (int i = 0; i < SLIPS; ++i)
        slip[i] = all[i];
}

static bool same(double got, double value)
{
    return isnan(got) ? isnan(value)
                      : fabs(got - value) <= 1e-9 * fabs(value);
}

static bool check_step(const struct runs *r, double got, double s,
                       const char *question)
{
    struct slip slip[SLIPS];
    struct check c = {.quantity = "*step",
                      .unit = "s",
                      .input = input(r),
                      .expected = s,
                      .tolerance = 1e-12 * s,
                      .because = "1e-12 of it: some epsilons of two "
                                 "logarithms",
                      .equation = "eq:chosen-step",
                      .question = question};
    slips_of(r, s, slip);
    for (int i = 0, used = 0; i < SLIPS && used < 8; ++i)
        if (same(got, slip[i].value) && !same(s, slip[i].value))
            c.mistakes[used++] = (struct check_mistake){
                slip[i].name, slip[i].value, slip[i].hint};
    return check_near(__FILE__, __LINE__, got, c);
}

static const char *verdict_name(enum verdict verdict)
{
    static const char *const name[] = {"OUT_OF_REACH", "TOO_FINE",
                                       "NO_ORDER", "CHOSEN"};
    return name[verdict];
}

static bool check_verdict(const struct runs *r, enum verdict got,
                          enum verdict expected, struct check_mistake one,
                          struct check_mistake other, const char *question)
{
    return CHECK_NEAR(
        (double)got,
        .quantity = "what is returned (0 OUT_OF_REACH, 1 TOO_FINE, 2 "
                    "NO_ORDER, 3 CHOSEN)",
        .input = input(r), .expected = expected, .tolerance = 0.0,
        .because = check_text("it should be %s", verdict_name(expected)),
        .equation = "eq:chosen-step", .question = question,
        .mistakes = {one, other});
}

static const struct check_mistake nothing = {NULL, 0.0, NULL};

/* A step is chosen, and this is it. */
static bool check_chosen(const struct runs *r, double s,
                         const char *question)
{
    static const char sign[] =
        "An error of -1 m is not a small one. What is the logarithm of a "
        "negative number, and does the sign matter here?";
    const struct result got = chosen(r);
    const bool negative = r->error[0] < 0.0 || r->error[1] < 0.0;
    const bool halved = fabs(r->h[0] / r->h[1] - 2.0) < 0.01;
    struct check_mistake one = nothing, other = nothing;
    if (negative) {
        one = (struct check_mistake){"sign-of-an-error", NO_ORDER, sign};
        other = (struct check_mistake){"sign-of-an-error", TOO_FINE, sign};
    } else if (!halved) {
        one = (struct check_mistake){
            "steps-that-halve", NO_ORDER,
            "These two errors do show the order. By which factor did the "
            "step shrink: is it two?"};
    }
    return check_verdict(r, got.verdict, CHOSEN, one, other, question) &&
           check_step(r, got.step, s, question);
}

/* None is chosen; the mistake is one that chooses, or gives another reason.
 */
static bool check_none(const struct runs *r, enum verdict expected,
                       struct check_mistake mistake, const char *question)
{
    const struct result got = chosen(r);
    return check_verdict(r, got.verdict, expected, mistake, nothing,
                         question) &&
           CHECK_NEAR(
               isnan(got.step), .quantity = "is *step NAN? (1 yes, 0 no)",
               .input = input(r), .expected = 1.0, .tolerance = 0.0,
               .because = "no step is chosen", .equation = "eq:chosen-step",
               .question = "No step could be chosen. What was to stand in "
                           "*step then?",
               .mistakes = {{"step-of-nothing", 0.0,
                             "There is a number in *step, or nothing was "
                             "put there. What was wanted when no step is "
                             "chosen?"}});
}

/* ---- the tests ---- */

/* Order 2, and 4/9 of the error; then 1/9; order 1, and 1/20. */
static void test_paper(void)
{
    static const char question[] =
        "The error is to become smaller by a factor. Which factor of the "
        "step does that, if the error goes as h^p?";
    const struct runs thirds = {2, {0.24, 0.12}, {0.36, 0.09}, 0.0, 0.04};
    const struct runs ninth = {2, {0.24, 0.12}, {3.6, 0.9}, 1e-9, 0.1};
    const struct runs first = {1, {0.24, 0.12}, {0.4, 0.2}, 0.0, 0.01};
    (void)(check_chosen(&thirds, 1.0 / 15.0, question) &&
           check_chosen(&ninth, 1.0 / 30.0, question) &&
           check_chosen(&first, 0.005, question));
}

static void test_orders(void)
{
    static const char question[] =
        "The two steps need not be one half of the other. Which power of "
        "their quotient is the quotient of the errors?";
    const struct runs fourth = {4, {0.3, 0.1}, {0.81, 0.01}, 0.0, 1e-6};
    const struct runs third = {3, {0.5, 0.1}, {0.125, 1e-3}, 0.0, 1e-12};
    const struct runs eighth = {8, {1.5, 1.0}, {0.0, 1.0}, 0.0, 1e-8};
    struct runs r = eighth;
    r.error[0] = pow(1.5, 8.0);
    (void)(check_chosen(&fourth, 1.0 / 120.0, question) &&
           check_chosen(&third, 1e-4 / 1.2, question) &&
           check_chosen(&r, 1.0 / 12.0, question));
}

static void test_signs(void)
{
    static const char question[] =
        "An error of -1 m is as large as one of 1 m. Does your step ask "
        "for the sign?";
    for (int i = 1; i < 4; ++i) {
        const struct runs r = {2,
                               {0.24, 0.12},
                               {i % 2 ? 0.36 : -0.36, i < 2 ? 0.09 : -0.09},
                               1e-9,
                               0.01};
        if (!check_chosen(&r, 1.0 / 30.0, question))
            return;
    }
}

/* Tolerances that the runs hold, nearly hold, and hold with much room. */
static void test_large(void)
{
    static const char question[] =
        "The tolerance is larger than an error that was measured. How "
        "large may the step be?";
    const struct runs between = {2, {0.24, 0.12}, {0.36, 0.09}, 0.0, 0.16};
    const struct runs close = {2, {0.24, 0.12}, {0.36, 0.09}, 0.0, 0.3};
    const struct runs far = {2, {0.24, 0.12}, {0.36, 0.1}, 0.0, 36.0};
    const struct runs just = {2, {0.24, 0.12}, {0.36, 0.09}, 0.0, 0.36};
    (void)(check_chosen(&between, 0.16 / 1.2, question) &&
           check_chosen(&close, sqrt(0.3) * 0.4 / 1.2, question) &&
           check_chosen(&far, 0.24, question) &&
           check_chosen(&just, 0.2, question));
}

/* A slope that is a little off is no reason to take it. */
static void test_nearly(void)
{
    static const double off[] = {0.1, -0.1, 0.29, -0.29};
    for (int i = 0; i < 4; ++i) {
        struct runs r = {2, {0.24, 0.12}, {0.0, 0.09}, 1e-9, 1e-6};
        r.error[0] = 0.09 * pow(2.0, 2.0 + off[i]);
        if (!check_chosen(&r, 0.12 / 300.0 / 1.2,
                          "The two errors show an order that is a little "
                          "off. Which order has the method, and through "
                          "which run does the curve go?"))
            return;
    }
}

static const char doubt[] =
    "Which order do these two errors show, and which should they?";

static void test_no_order(void)
{
    static const double q[] = {0.0, 1.0, -2.0, 1.69, 2.31, 3.0, 5.0};
    for (int i = 0; i < 7; ++i) {
        struct runs r = {2, {0.27, 0.09}, {0.0, 0.01}, 1e-9, 1e-4};
        r.error[0] = 0.01 * pow(3.0, q[i]);
        const struct check_mistake low = {
            "order-unasked", CHOSEN,
            "These errors do not go as h^p: what would a step be worth "
            "that was chosen as if they did?"};
        const struct check_mistake high = {
            "order-too-high", CHOSEN,
            "These errors show a higher order than the method has. Is that "
            "a reason to trust them?"};
        if (!check_none(&r, NO_ORDER, q[i] < 2.0 ? low : high, doubt))
            return;
    }
}

static void test_blown_up(void)
{
    static const struct check_mistake slip = {
        "blown-up-unnoticed", CHOSEN,
        "One of the runs blew up, and a step is chosen all the same. What "
        "does C answer to comparisons with not-a-number?"};
    static const double error[][2] = {
        {INFINITY, 0.01}, {NAN, 0.01},         {NAN, NAN},
        {INFINITY, NAN},  {0.01, INFINITY},    {-INFINITY, 0.01},
        {0.01, NAN},      {INFINITY, INFINITY}};
    for (int i = 0; i < 8; ++i) {
        const struct runs r = {
            2, {0.2, 0.1}, {error[i][0], error[i][1]}, 1e-9, 1e-4};
        if (!check_none(&r, NO_ORDER, slip,
                        "Which order does a run show that blew up?"))
            return;
    }
}

static const struct check_mistake unnoticed = {
    "rounding-unnoticed", CHOSEN,
    "One of these errors is mostly rounding. Which order does it show?"};
static const struct check_mistake no_order = {
    "rounding-unnoticed", NO_ORDER,
    "It is no wonder that these show no order: how large are they, "
    "compared with the rounding? Which reason comes first?"};

static void test_rounding(void)
{
    static const char question[] =
        "How large are these errors, compared with the rounding?";
    static const double unit = 1.0 / 1024.0;
    const struct runs fine = {2, {0.2, 0.1}, {0.04, 9e-6}, 1e-6, 1e-4};
    const struct runs looks = {2, {0.2, 0.1}, {2e-5, -5e-6}, 1e-6, 2e-5};
    const struct runs both = {2, {0.2, 0.1}, {-3e-7, 8e-7}, 1e-6, 1e-4};
    const struct runs large = {2, {0.2, 0.1}, {7e-6, 5e-4}, 1e-6, 1e-4};
    const struct runs zero = {2, {0.2, 0.1}, {0.04, 0.0}, 0.0, 1e-4};
    const struct runs just = {
        2, {0.2, 0.1}, {40.0 * unit, -10.0 * unit}, unit, 1.0};
    const struct runs wild = {
        2, {0.2, 0.1}, {10.0 * unit, 20.0 * unit}, unit, 1.0};
    (void)(check_none(&looks, TOO_FINE, unnoticed, question) &&
           check_none(&fine, TOO_FINE, no_order, question) &&
           check_none(&both, TOO_FINE, no_order, question) &&
           check_none(&large, TOO_FINE, no_order, question) &&
           check_none(&zero, TOO_FINE, no_order, question) &&
           check_none(&just, TOO_FINE, unnoticed, question) &&
           check_none(&wild, TOO_FINE, no_order, question));
}

/* A little above ten times the rounding is enough. */
static void test_above(void)
{
    const struct runs r = {
        2, {0.4, 0.2}, {0.00404, 0.00101}, 1e-4, 0.00404};
    const struct runs s = {2, {0.4, 0.2}, {0.4, 0.1}, 1e-4, 0.001001};
    static const char question[] =
        "All of these are more than 10 times the rounding. Is there a "
        "reason to refuse?";
    (void)(check_chosen(&r, 0.4 / 1.2, question) &&
           check_chosen(&s, 0.2 * sqrt(0.01001) / 1.2, question));
}

static void test_out_of_reach(void)
{
    static const char question[] =
        "How large is the tolerance, compared with the rounding?";
    static const double unit = 1.0 / 1024.0;
    static const struct check_mistake slip = {
        "tolerance-below-rounding", CHOSEN,
        "A step is chosen here, and the error that is asked for is no "
        "larger than rounding errors may be. What would happen?"};
    const struct runs below = {2, {0.2, 0.1}, {0.04, 0.01}, 1e-6, 3e-6};
    const struct runs far = {2, {0.2, 0.1}, {0.04, 0.01}, 1e-6, 3e-9};
    const struct runs just = {
        2, {0.2, 0.1}, {400 * unit, 100 * unit}, unit, 10.0 * unit};
    const struct runs first = {2, {0.2, 0.1}, {0.04, 3e-6}, 1e-6, 3e-6};
    const struct runs odd = {2, {0.2, 0.1}, {0.04, NAN}, 1e-6, 3e-6};
    (void)(check_none(&below, OUT_OF_REACH, slip, question) &&
           check_none(&far, OUT_OF_REACH, slip, question) &&
           check_none(&just, OUT_OF_REACH, slip, question) &&
           check_none(&first, OUT_OF_REACH, nothing,
                      "Two reasons hold. Which one comes first?") &&
           check_none(&odd, OUT_OF_REACH, nothing,
                      "Two reasons hold. Which one comes first?"));
}

/* The leapfrog turns an oscillator by 2 asin(h/2) in each step. What is its
   error after one second, in so many steps? */
static double leapfrog(double steps)
{
    return cos(2.0 * steps * asin(0.5 / steps)) - cos(1.0);
}

/* The step is taken at its word: a run with it holds the tolerance, and one
   with 1.3 times the step does not. */
static void test_leapfrog(void)
{
    for (int i = 4; i <= 10; ++i) {
        const struct runs r = {2,
                               {1.0 / 8, 1.0 / 12},
                               {leapfrog(8), leapfrog(12)},
                               1e-15,
                               0.1 * pow(10.0, -0.9 * i)};
        const struct result got = chosen(&r);
        const double steps = 1.0 / got.step;
        static const char question[] =
            "After 1 s of an oscillator the leapfrog is asked: is the step "
            "small enough, and no smaller than it must be?";
        if (!check_verdict(&r, got.verdict, CHOSEN, nothing, nothing,
                           question) ||
            !CHECK_NEAR(fabs(leapfrog(steps)) / r.tolerance,
                        .quantity = "error of the leapfrog with this step, "
                                    "in tolerances",
                        .input = input(&r), .expected = 1.0 / 1.44,
                        .tolerance = 0.02,
                        .because = "1/1.2^2, and terms of higher order",
                        .equation = "eq:chosen-step", .question = question))
            return;
    }
}

/* ---- drawn runs ---- */

/* Two runs that show the order q. */
static struct runs draw_runs(double p, double q)
{
    const double fine = pow(10.0, check_draw(-5.0, 3.0));
    const double quotient = check_draw(1.2, 6.0);
    struct runs r = {.p = p, .h = {0.0, check_draw(0.01, 2.0)}};
    r.h[0] = r.h[1] * quotient;
    r.error[1] = check_draw_whole(0, 1) ? fine : -fine;
    r.error[0] = pow(quotient, q) * (check_draw_whole(0, 1) ? fine : -fine);
    r.rounding = check_draw_whole(0, 2) ? 0.0 : fine * 1e-14;
    return r;
}

/* The answer first: the step, and from it the tolerance. */
static void test_drawn_step(void)
{
    for (int i = 0; i < 50; ++i) {
        const double p = i % 2 ? check_draw_whole(1, 8) : check_draw(1, 8);
        struct runs r = draw_runs(p, p + check_draw(-0.28, 0.28));
        const double shrink = check_draw(-1.2, 0.5);
        const double s = r.h[1] * pow(10.0, shrink);
        r.tolerance = fabs(r.error[1]) * pow(1.2 * s / r.h[1], p);
        if (fabs(s / r.h[0] - 1.0) < 1e-6)
            continue;
        if (!check_chosen(&r, s < r.h[0] ? s : r.h[0],
                          "Which step has 1/1.2 of the length at which the "
                          "curve reaches the tolerance? Is it larger than "
                          "the larger one?"))
            return;
    }
}

static void test_drawn_none(void)
{
    for (int i = 0; i < 50; ++i) {
        const double p = check_draw(1.0, 8.0), off = check_draw(0.32, 2.0);
        struct runs r = draw_runs(p, i % 2 ? p + off : p - off);
        const int reason = check_draw_whole(0, 2);
        const double least = fmin(fabs(r.error[0]), fabs(r.error[1]));
        r.tolerance = least * check_draw(1.0, 5.0);
        r.rounding = 0.1 * (reason == OUT_OF_REACH ? r.tolerance
                            : reason == TOO_FINE   ? least
                                                   : 0.9 * least);
        r.rounding *= reason == NO_ORDER ? check_draw(0.0, 0.99)
                                         : check_draw(1.01, 1.2);
        if (reason == TOO_FINE)
            r.tolerance = 20.0 * r.rounding;
        if (!check_none(&r, (enum verdict)reason, nothing,
                        "Which of the reasons to choose no step is the "
                        "first that holds?"))
            return;
    }
}

const struct check_suite check_suite = {
    .file = "12b-step.c",
    .title = "A step from two errors",
    .minutes = 25,
    .tests =
        {{"a part of the error, by the second order", test_paper, 2, 0},
         {"other orders and other pairs of steps", test_orders, 1, 0},
         {"errors of either sign", test_signs, 1, 0},
         {"a tolerance that is held already", test_large, 1, 0},
         {"an order that is a little off", test_nearly, 1, 0},
         {"errors that show no such order", test_no_order, 2, 0},
         {"a run that blew up", test_blown_up, 1, 0},
         {"errors that are only rounding", test_rounding, 1, 0},
         {"errors that are just large enough", test_above, 1, 0},
         {"a tolerance that is below rounding", test_out_of_reach, 1, 0},
         {"the leapfrog takes the step at its word", test_leapfrog, 1, 0},
         {"drawn steps", test_drawn_step, 1, 2},
         {"drawn reasons to choose none", test_drawn_none, 1, 2},
         {0}},
};
